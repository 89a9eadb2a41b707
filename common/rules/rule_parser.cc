#include <algorithm>
#include <charconv>
#include <cmath>

#include "common/rules/literal_parser.h"
#include "common/rules/rule_error.h"
#include "common/rules/rule_text.h"
#include "common/rules/tokens.h"
#include "common/text/nearest.h"

namespace cell::rules {
namespace {

/// Reads rules, line after line.
class RuleParser {
 public:
  explicit RuleParser(std::shared_ptr<const SymbolTable> symbols)
      : rules_{std::move(symbols), {}}, literals_(rules_.symbols) {}

  void Read(const TextLine& line) {
    TokenReader in(line.text, line.place);
    if (in.AtEnd()) return;
    if (in.Peek() == "Action") return BeginRule(in);
    if (!rule_) in.Fail("expected 'Action: NAME(X, Y)'");
    if (in.TakeIf("References")) return ReadReferences(in);
    if (in.TakeIf("Preconditions")) return ReadPreconditions(in);
    if (in.TakeIf("Effects")) {
      in.Expect(":");
      stage_ = Stage::kEffects;
      return;
    }
    if (stage_ != Stage::kEffects) {
      in.Fail("expected References:, Preconditions:, or Effects:");
    }
    if (in.TakeIf("each")) return ReadEach(in);
    ReadOutcome(in);
  }

  NdrRules Finish() {
    EndRule();
    return std::move(rules_);
  }
  /// Of the rules, each where it begins.
  const std::vector<int>& lines() const { return lines_; }

 private:
  enum class Stage { kBegin, kReferences, kPreconditions, kEffects };

  void BeginRule(TokenReader& in) {
    EndRule();
    in.Expect("Action");
    in.Expect(":");
    rule_.emplace();
    place_ = in.place();
    stage_ = Stage::kBegin;
    has_noise_ = false;
    is_after_outcome_ = false;
    const std::string name = in.Word("the name of an action");
    const auto action = symbols().Find(name);
    if (!action || symbols()[*action].kind != Symbol::Kind::kAction) {
      in.Fail(fmt::format("there is no action '{}'{}", name,
                          NamesInstead(name, ActionNames())));
    }
    rule_->action = *action;
    in.Expect("(");
    while (!in.TakeIf(")")) {
      rule_->arguments.push_back(NewVariable(in));
      if (in.Peek() != ")") in.Expect(",");
    }
    const size_t arity = static_cast<size_t>(symbols()[*action].arity);
    if (rule_->arguments.size() != arity) {
      in.Fail(fmt::format("'{}' has {} arguments, not {}", name, arity,
                          rule_->arguments.size()));
    }
    ExpectEnd(in);
  }

  void EndRule() {
    if (!rule_) return;
    double sum = rule_->noise;
    for (const Outcome& outcome : rule_->outcomes) sum += outcome.probability;
    if (std::abs(sum - 1) > 1e-6) {
      place_.Fail(fmt::format(
          "the probabilities of this rule's effects sum to {}, not 1", sum));
    }
    rules_.rules.push_back(std::move(*rule_));
    lines_.push_back(place_.line);
    rule_.reset();
  }

  void Advance(Stage stage, const TokenReader& in) {
    if (stage_ >= stage) {
      in.Fail("the order is References:, Preconditions:, Effects:, each once");
    }
    stage_ = stage;
  }

  void ReadReferences(TokenReader& in) {
    Advance(Stage::kReferences, in);
    in.Expect(":");
    for (;;) {
      rule_->references.push_back({NewVariable(in), {}});
      in.Expect(":");
      std::vector<Literal> literals =
          literals_.ReadList(ListKind::kConditions, *rule_, in);
      if (literals.empty()) in.Fail("a reference needs a literal");
      rule_->references.back().literals = std::move(literals);
      if (!in.TakeIf(";")) break;
    }
    ExpectEnd(in);
  }

  void ReadPreconditions(TokenReader& in) {
    Advance(Stage::kPreconditions, in);
    in.Expect(":");
    if (!in.TakeIf("none")) {
      rule_->context = literals_.ReadList(ListKind::kConditions, *rule_, in);
    }
    ExpectEnd(in);
  }

  void ReadOutcome(TokenReader& in) {
    const double probability = ReadProbability(in);
    in.Expect(":");
    is_after_outcome_ = in.Peek() != "noise";
    if (in.TakeIf("noise")) {
      if (has_noise_) in.Fail("this rule has two noise outcomes");
      has_noise_ = true;
      rule_->noise = probability;
    } else if (in.TakeIf("nothing")) {
      rule_->outcomes.push_back({probability, {}});
    } else {
      rule_->outcomes.push_back(
          {probability, literals_.ReadList(ListKind::kChanges, *rule_, in)});
    }
    ExpectEnd(in);
  }

  /// "each P: not clear(P) if on(P, X)", of the outcome before it
  void ReadEach(TokenReader& in) {
    if (!is_after_outcome_) in.Fail("'each' follows an effect, not the noise");
    QuantifiedChange each;
    each.variable = NewVariable(in);
    in.Expect(":");
    // The variable is known to the literals of this line only.
    rule_->references.push_back({each.variable, {}});
    each.change = literals_.Read(ListKind::kChanges, *rule_, in);
    if (in.TakeIf("if"))
      each.where = literals_.ReadList(ListKind::kConditions, *rule_, in);
    rule_->references.pop_back();
    ExpectEnd(in);
    rule_->outcomes.back().each.push_back(std::move(each));
  }

  static double ReadProbability(TokenReader& in) {
    std::string word = in.Word("a probability");
    // 1e-05 is three tokens.
    if (word.ends_with("e") && (in.Peek() == "-" || in.Peek() == "+")) {
      word += in.Next() == "-" ? "-" : "";
      word += in.Word("an exponent");
    }
    double value = -1;
    const auto [end, error] =
        std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() ||
        !(value >= 0 && value <= 1)) {
      in.Fail(fmt::format("'{}' is no probability: from 0 to 1", word));
    }
    return value;
  }

  std::string NewVariable(TokenReader& in) {
    const std::string name = in.Word("a variable");
    if (!IsVariableName(name)) {
      in.Fail(
          fmt::format("'{}' is no variable: capital letters begin them", name));
    }
    for (int i = 0; i < rule_->num_variables(); ++i) {
      if (rule_->VariableName(i) == name) {
        in.Fail(fmt::format("there are two variables '{}'", name));
      }
    }
    return name;
  }

  static void ExpectEnd(TokenReader& in) {
    if (in.AtEnd()) return;
    in.Fail(fmt::format("expected the end of the line, not '{}'", in.Peek()));
  }

  std::vector<std::string> ActionNames() const {
    std::vector<std::string> names;
    for (const int action : symbols().Actions()) {
      names.push_back(symbols()[action].name);
    }
    return names;
  }

  const SymbolTable& symbols() const { return *rules_.symbols; }

  NdrRules rules_;
  LiteralParser literals_;
  std::vector<int> lines_;
  std::optional<Rule> rule_;
  Place place_;  // of the rule
  Stage stage_ = Stage::kBegin;
  bool has_noise_ = false;
  bool is_after_outcome_ = false;
};

using LineIterator = std::vector<TextLine>::const_iterator;

LineIterator FirstRuleIn(const std::vector<TextLine>& lines) {
  return std::ranges::find_if(
      lines, [](const TextLine& l) { return l.text.starts_with("Action:"); });
}

/// What the first lines of a file declare.
SymbolTable SymbolsIn(LineIterator begin, LineIterator end,
                      const std::string& file) {
  std::string declarations;
  for (auto it = begin; it != end; ++it) declarations += it->text + "\n";
  return SymbolTable::Parse(declarations, file);
}

}  // namespace

NdrRules ParseRules(const std::string& text, const std::string& file) {
  const std::vector<TextLine> lines = SplitLines(text, file);
  const auto first_rule = FirstRuleIn(lines);
  RuleParser parser(std::make_shared<const SymbolTable>(
      SymbolsIn(lines.begin(), first_rule, file)));
  for (auto it = first_rule; it != lines.end(); ++it) parser.Read(*it);
  return parser.Finish();
}

std::vector<PlacedRule> ParseRulesOf(std::shared_ptr<const SymbolTable> symbols,
                                     const std::string& text,
                                     const std::string& file) {
  const std::vector<TextLine> lines = SplitLines(text, file);
  const auto first_rule = FirstRuleIn(lines);
  SymbolsIn(lines.begin(), first_rule, file);  // what is none is an error
  RuleParser parser(std::move(symbols));
  for (auto it = first_rule; it != lines.end(); ++it) parser.Read(*it);
  const NdrRules rules = parser.Finish();
  std::vector<PlacedRule> placed;
  for (size_t i = 0; i < rules.rules.size(); ++i) {
    placed.push_back({parser.lines()[i], rules.rules[i]});
  }
  return placed;
}

}  // namespace cell::rules
