#include <algorithm>
#include <charconv>
#include <cmath>

#include "common/rules/rule_error.h"
#include "common/rules/rule_text.h"
#include "common/rules/tokens.h"
#include "common/text/nearest.h"

namespace cell::rules {
namespace {

/// What may stand in a list of literals.
enum class ListKind { kConditions, kChanges };

/// Reads rules, line after line.
class RuleParser {
 public:
  explicit RuleParser(std::shared_ptr<const SymbolTable> symbols)
      : rules_{std::move(symbols), {}} {}

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
      std::vector<Literal> literals = ReadList(ListKind::kConditions, in);
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
      rule_->context = ReadList(ListKind::kConditions, in);
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
          {probability, ReadList(ListKind::kChanges, in)});
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
    each.change = ReadLiteral(ListKind::kChanges, in);
    if (in.TakeIf("if")) each.where = ReadList(ListKind::kConditions, in);
    rule_->references.pop_back();
    ExpectEnd(in);
    rule_->outcomes.back().each.push_back(std::move(each));
  }

  static double ReadProbability(TokenReader& in) {
    std::string word = in.Word("a probability");
    // 1e-05 is three tokens.
    if (word.ends_with("e") && (in.Peek() == "-" || in.Peek() == "+")) {
      word += in.Take() == "-" ? "-" : "";
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

  std::vector<Literal> ReadList(ListKind kind, TokenReader& in) {
    std::vector<Literal> literals;
    do {
      literals.push_back(ReadLiteral(kind, in));
    } while (in.TakeIf(","));
    return literals;
  }

  Literal ReadLiteral(ListKind kind, TokenReader& in) {
    Literal literal;
    const bool is_negated = in.TakeIf("not");
    if (in.Peek(1) != "(") return ReadSame(kind, is_negated, in);
    const std::string name = in.Word("a predicate");
    const auto symbol = symbols().Find(name);
    if (!symbol || symbols()[*symbol].kind == Symbol::Kind::kAction) {
      in.Fail(fmt::format(
          "there is no predicate or function '{}'{}", name,
          NamesInstead(name, NamesIn(symbols().all(), &Symbol::name))));
    }
    literal.symbol = *symbol;
    in.Expect("(");
    while (!in.TakeIf(")")) {
      literal.terms.push_back(ReadTerm(in));
      if (in.Peek() != ")") in.Expect(",");
    }
    ReadComparison(is_negated, &literal, in);
    Check(literal, kind, in);
    return literal;
  }

  /// "X = Y", "X != c"
  Literal ReadSame(ListKind kind, bool is_negated, TokenReader& in) {
    Literal literal;
    literal.symbol = Literal::kSame;
    literal.terms.push_back(ReadTerm(in));
    if (is_negated || kind == ListKind::kChanges) {
      in.Fail("expected a predicate: NAME(X, Y)");
    }
    if (in.TakeIf("!=")) {
      literal.comparison = Comparison::kFalse;
    } else {
      in.Expect("=");
    }
    literal.terms.push_back(ReadTerm(in));
    return literal;
  }

  void ReadComparison(bool is_negated, Literal* literal, TokenReader& in) {
    const Symbol& symbol = symbols()[literal->symbol];
    literal->comparison = is_negated ? Comparison::kFalse : Comparison::kTrue;
    if (!symbol.is_integer) return;
    if (is_negated) in.Fail("a comparison has no 'not'");
    const std::pair<const char*, Comparison> signs[] = {
        {"=", Comparison::kEqual},
        {"!=", Comparison::kNotEqual},
        {"<=", Comparison::kAtMost},
        {">=", Comparison::kAtLeast}};
    for (const auto& [sign, comparison] : signs) {
      if (!in.TakeIf(sign)) continue;
      literal->comparison = comparison;
      literal->value = in.Integer("a whole number");
      return;
    }
    in.Fail(
        fmt::format("'{}' is a function: expected =, !=, <= or >= and a "
                    "number",
                    symbol.name));
  }

  void Check(const Literal& literal, ListKind kind, const TokenReader& in) {
    const Symbol& symbol = symbols()[literal.symbol];
    if (static_cast<int>(literal.terms.size()) != symbol.arity) {
      in.Fail(fmt::format("'{}' has {} arguments, not {}", symbol.name,
                          symbol.arity, literal.terms.size()));
    }
    const bool has_any = std::ranges::any_of(literal.terms, [](const Term& t) {
      return t.kind == Term::Kind::kAny;
    });
    if (has_any && (symbol.is_integer || kind == ListKind::kChanges)) {
      in.Fail("'_' can stand in a condition on a predicate only");
    }
    if (kind == ListKind::kConditions) return;
    if (symbol.is_derived()) {
      in.Fail(
          fmt::format("'{}' is derived: no effect can change it", symbol.name));
    }
    if (symbol.is_integer && literal.comparison != Comparison::kEqual) {
      in.Fail("an effect gives a function a value: f(X) = 1");
    }
  }

  Term ReadTerm(TokenReader& in) {
    const std::string name = in.Word("a variable, a constant, or _");
    if (name == "_") return {Term::Kind::kAny, 0};
    if (IsVariableName(name)) {
      for (int i = 0; i < rule_->num_variables(); ++i) {
        if (rule_->VariableName(i) == name) {
          return {Term::Kind::kVariable, i};
        }
      }
      in.Fail(fmt::format("there is no variable '{}' in this rule", name));
    }
    const auto& constants = symbols().constants();
    const auto it = std::ranges::find(constants, name);
    if (it == constants.end()) {
      in.Fail(fmt::format("there is no constant '{}'{}", name,
                          NamesInstead(name, constants)));
    }
    return {Term::Kind::kObject, static_cast<int>(it - constants.begin())};
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
  std::vector<int> lines_;
  std::optional<Rule> rule_;
  Place place_;  // of the rule
  Stage stage_ = Stage::kBegin;
  bool has_noise_ = false;
  bool is_after_outcome_ = false;
};

std::vector<TextLine>::const_iterator FirstRuleIn(
    const std::vector<TextLine>& lines) {
  return std::ranges::find_if(
      lines, [](const TextLine& l) { return l.text.starts_with("Action:"); });
}

}  // namespace

NdrRules ParseRules(const std::string& text, const std::string& file) {
  const std::vector<TextLine> lines = SplitLines(text, file);
  const auto first_rule = FirstRuleIn(lines);
  std::string declarations;
  for (auto it = lines.begin(); it != first_rule; ++it) {
    declarations += it->text + "\n";
  }
  RuleParser parser(std::make_shared<const SymbolTable>(
      SymbolTable::Parse(declarations, file)));
  for (auto it = first_rule; it != lines.end(); ++it) parser.Read(*it);
  return parser.Finish();
}

std::vector<PlacedRule> ParseRulesOf(std::shared_ptr<const SymbolTable> symbols,
                                     const std::string& text,
                                     const std::string& file) {
  const std::vector<TextLine> lines = SplitLines(text, file);
  RuleParser parser(std::move(symbols));
  for (auto it = FirstRuleIn(lines); it != lines.end(); ++it) parser.Read(*it);
  const NdrRules rules = parser.Finish();
  std::vector<PlacedRule> placed;
  for (size_t i = 0; i < rules.rules.size(); ++i) {
    placed.push_back({parser.lines()[i], rules.rules[i]});
  }
  return placed;
}

}  // namespace cell::rules
