#include "common/rexd/ppddl_rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>

#include "common/rules/symbols.h"

namespace cell::rexd {
namespace {

/// The first list within `in`, or `in` itself, that begins with the word.
const ppddl::Expression* FindList(const ppddl::Expression& in,
                                  const std::string& word) {
  if (in.BeginsWith(word)) return &in;
  for (const ppddl::Expression& item : in.items) {
    if (const ppddl::Expression* found = FindList(item, word)) return found;
  }
  return nullptr;
}

const char* WordOf(ppddl::Condition::Kind kind) {
  switch (kind) {
    case ppddl::Condition::Kind::kOr:
      return "or";
    case ppddl::Condition::Kind::kImply:
      return "imply";
    case ppddl::Condition::Kind::kForall:
      return "forall";
    case ppddl::Condition::Kind::kExists:
      return "exists";
    case ppddl::Condition::Kind::kNot:
      return "not";
    default:
      return "and";
  }
}

std::string VariableName(const std::string& name) {
  std::string text = name.substr(1);
  if (!std::isalpha(static_cast<unsigned char>(text[0]))) text = "V" + text;
  text[0] =
      static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace

void FailAt(const ppddl::Expression& in, const std::string& word,
            const std::string& message) {
  const ppddl::Expression* found = FindList(in, word);
  (found == nullptr ? in : *found).Fail(message);
}

const ppddl::Expression& PpddlRule::PartOf(const std::string& key) const {
  for (size_t i = 0; i + 1 < where_.items.size(); ++i) {
    if (where_.items[i].Is(key)) return where_.items[i + 1];
  }
  return where_;
}

PpddlRule::PpddlRule(const ppddl::Domain& domain, const ppddl::Action& action,
                     const ppddl::Expression& where)
    : domain_(domain), action_(action), where_(where) {
  FindReferences(action.precondition);
  AddCondition(action.precondition, false);
  if (ArgumentNames().size() > static_cast<size_t>(rules::kMaxArity)) {
    where.Fail(fmt::format("'{}' has {} arguments; rules have at most {}",
                           action.name, ArgumentNames().size(),
                           rules::kMaxArity));
  }
}

/// "stack 2 action <-- block(X) block(Y)"
std::string PpddlRule::Declaration() const {
  std::string types;
  int number = 0;
  for (size_t i = 0; i < action_.parameters.size(); ++i) {
    if (references_.contains(static_cast<int>(i))) continue;
    const int type = action_.parameters[i].type;
    if (type != 0)
      types += fmt::format(" {}({})", TypeName(type), "XYZ"[number]);
    ++number;
  }
  return fmt::format("{} {} action{}{}\n", action_.name, number,
                     types.empty() ? "" : " <--", types);
}

std::string PpddlRule::Text() const {
  std::string text = fmt::format("\nAction: {}({})\n", action_.name,
                                 fmt::join(ArgumentNames(), ", "));
  std::string references;
  std::vector<std::string> context = context_;
  for (const auto& [parameter, literals] : references_) {
    references += fmt::format("{} {}: {}", references.empty() ? "" : ";",
                              NameOf(parameter), fmt::join(literals, ", "));
    for (const std::string& l : literals) std::erase(context, l);
    const int type = action_.parameters[static_cast<size_t>(parameter)].type;
    if (type != 0) {
      context.push_back(
          fmt::format("{}({})", TypeName(type), NameOf(parameter)));
    }
  }
  if (!references.empty()) text += "References:" + references + "\n";
  if (!context.empty()) {
    text += fmt::format("Preconditions: {}\n", fmt::join(context, ", "));
  }
  text += "Effects:\n";
  for (const Outcome& outcome : OutcomesOf(action_.effect)) {
    text += fmt::format("  {}: {}\n", outcome.probability, Changes(outcome));
  }
  return text + "  0: noise\n";
}

std::string PpddlRule::TypeName(int type) const {
  return domain_.types[static_cast<size_t>(type)].name;
}
std::string PpddlRule::NameOf(int parameter) const {
  return VariableName(action_.parameters[static_cast<size_t>(parameter)].name);
}

std::vector<std::string> PpddlRule::ArgumentNames() const {
  std::vector<std::string> names;
  for (size_t i = 0; i < action_.parameters.size(); ++i) {
    const int parameter = static_cast<int>(i);
    if (!references_.contains(parameter)) names.push_back(NameOf(parameter));
  }
  return names;
}

/// @param other  text of the variables after the parameters: `_`, or the
///               parameter that they are to be
std::string PpddlRule::TermText(const ppddl::Term& term,
                                const std::string& other) const {
  const auto index = static_cast<size_t>(term.index);
  if (!term.is_variable) return domain_.constants[index].name;
  return index < action_.parameters.size() ? NameOf(term.index) : other;
}

std::string PpddlRule::AtomText(const ppddl::Condition& atom,
                                const std::string& other) const {
  std::vector<std::string> terms;
  for (const ppddl::Term& t : atom.terms) terms.push_back(TermText(t, other));
  return fmt::format(
      "{}({})", domain_.predicates[static_cast<size_t>(atom.predicate)].name,
      fmt::join(terms, ", "));
}

/// "(forall (?o) (imply (and (on ?x ?o) ...) (= ?o ?y)))": ?y is a reference.
bool PpddlRule::IsReference(const ppddl::Condition& condition, int* parameter,
                            std::vector<std::string>* literals) const {
  if (condition.kind != ppddl::Condition::Kind::kForall ||
      condition.variables.size() != 1 || condition.variables[0].type != 0) {
    return false;
  }
  const ppddl::Condition& body = condition.parts[0];
  const int bound = static_cast<int>(action_.parameters.size());
  const bool is_imply = body.kind == ppddl::Condition::Kind::kImply &&
                        body.parts[1].kind == ppddl::Condition::Kind::kEqual;
  if (!is_imply) return false;
  const auto& same = body.parts[1].terms;
  if (!(same[0] == ppddl::Term{true, bound}) || !same[1].is_variable ||
      same[1].index >= bound) {
    return false;
  }
  *parameter = same[1].index;
  std::vector<ppddl::Condition> parts = {body.parts[0]};
  if (parts[0].kind == ppddl::Condition::Kind::kAnd)
    parts = body.parts[0].parts;
  for (const ppddl::Condition& part : parts) {
    const bool is_negated = part.kind == ppddl::Condition::Kind::kNot;
    const ppddl::Condition& atom = is_negated ? part.parts[0] : part;
    if (atom.kind != ppddl::Condition::Kind::kAtom) return false;
    literals->push_back((is_negated ? "not " : "") +
                        AtomText(atom, NameOf(*parameter)));
  }
  return !literals->empty();
}

void PpddlRule::FindReferences(const ppddl::Condition& condition) {
  int parameter = 0;
  std::vector<std::string> literals;
  if (condition.kind == ppddl::Condition::Kind::kAnd) {
    for (const ppddl::Condition& part : condition.parts) FindReferences(part);
  } else if (IsReference(condition, &parameter, &literals)) {
    references_.emplace(parameter, literals);
  }
}

void PpddlRule::AddCondition(const ppddl::Condition& condition,
                             bool is_negated) {
  using enum ppddl::Condition::Kind;
  int parameter = 0;
  std::vector<std::string> literals;
  switch (condition.kind) {
    case kAtom:
      return context_.push_back((is_negated ? "not " : "") +
                                AtomText(condition, "_"));
    case kEqual:
      return context_.push_back(fmt::format(
          "{} {} {}", TermText(condition.terms[0], "_"),
          is_negated ? "!=" : "=", TermText(condition.terms[1], "_")));
    case kNot:
      return AddCondition(condition.parts[0], !is_negated);
    case kForall:
      if (!is_negated && IsReference(condition, &parameter, &literals)) return;
      return AddQuantified(condition, is_negated);
    case kExists:
      return AddQuantified(condition, is_negated);
    default:
      break;
  }
  // An "or" of one part is that part.
  const bool is_all = (condition.kind == kAnd && !is_negated) ||
                      (condition.kind == kOr && is_negated) ||
                      condition.parts.size() == 1;
  if (!is_all || condition.kind == kImply) {
    FailAt(PartOf(":precondition"), WordOf(condition.kind),
           fmt::format("rules have no words for '{}'; write an action "
                       "for each case",
                       WordOf(condition.kind)));
  }
  for (const ppddl::Condition& part : condition.parts) {
    AddCondition(part, is_negated);
  }
}

/// Some object, or none, for which an atom holds: `_`.
void PpddlRule::AddQuantified(const ppddl::Condition& condition,
                              bool is_negated) {
  const bool is_forall = condition.kind == ppddl::Condition::Kind::kForall;
  const ppddl::Condition* part = &condition.parts[0];
  bool is_false = false;
  while (
      part->kind == ppddl::Condition::Kind::kNot ||
      (part->kind == ppddl::Condition::Kind::kAnd && part->parts.size() == 1)) {
    is_false ^= part->kind == ppddl::Condition::Kind::kNot;
    part = &part->parts[0];
  }
  if (part->kind != ppddl::Condition::Kind::kAtom || is_false != is_forall ||
      !AreOnce(*part, condition.variables)) {
    FailAt(PartOf(":precondition"), WordOf(condition.kind),
           fmt::format("rules can say '{}' only as '_': of one predicate, "
                       "each variable once and of its type",
                       WordOf(condition.kind)));
  }
  // Not for all that not: for some.
  const bool is_some = is_forall == is_negated;
  context_.push_back((is_some ? "" : "not ") + AtomText(*part, "_"));
}

/// True if each variable is once in the atom and as wide as its place.
bool PpddlRule::AreOnce(const ppddl::Condition& atom,
                        const std::vector<ppddl::Variable>& variables) const {
  const auto& symbol = domain_.predicates[static_cast<size_t>(atom.predicate)];
  std::set<int> seen;
  for (size_t i = 0; i < atom.terms.size(); ++i) {
    const int bound =
        atom.terms[i].index - static_cast<int>(action_.parameters.size());
    if (!atom.terms[i].is_variable || bound < 0) continue;
    const bool is_wide =
        domain_.IsA(symbol.parameters[i].type,
                    variables.at(static_cast<size_t>(bound)).type);
    if (!is_wide || !seen.insert(bound).second) return false;
  }
  return seen.size() == variables.size();
}

std::vector<PpddlRule::Outcome> PpddlRule::OutcomesOf(
    const ppddl::Effect& effect) const {
  using enum ppddl::Effect::Kind;
  switch (effect.kind) {
    case kAdd:
    case kDelete: {
      const std::string atom = AtomText(
          {ppddl::Condition::Kind::kAtom, effect.symbol, effect.terms, {}, {}},
          "_");
      return effect.kind == kAdd ? std::vector<Outcome>{{1, {atom}, {}}}
                                 : std::vector<Outcome>{{1, {}, {atom}}};
    }
    case kIncrease:
    case kDecrease:
      return {Outcome{}};
    case kWhen:
      FailAt(PartOf(":effect"), "when",
             "rules have no conditional effects; write an action for each "
             "case");
    case kForall:
      FailAt(PartOf(":effect"), "forall", "rules have no quantified effects");
    case kProbabilistic:
      return ByChance(effect);
    case kAnd:
      return Jointly(effect);
  }
  return {};
}

std::vector<PpddlRule::Outcome> PpddlRule::Jointly(
    const ppddl::Effect& effect) const {
  std::vector<Outcome> outcomes = {Outcome{}};
  for (const ppddl::Effect& part : effect.parts) {
    std::vector<Outcome> joint;
    for (const Outcome& other : OutcomesOf(part)) {
      for (Outcome outcome : outcomes) {
        outcome.probability *= other.probability;
        const auto append = [](const auto& from, auto* to) {
          to->insert(to->end(), from.begin(), from.end());
        };
        append(other.added, &outcome.added);
        append(other.deleted, &outcome.deleted);
        joint.push_back(std::move(outcome));
      }
    }
    outcomes = std::move(joint);
  }
  return outcomes;
}

std::vector<PpddlRule::Outcome> PpddlRule::ByChance(
    const ppddl::Effect& effect) const {
  std::vector<Outcome> outcomes;
  double left = 1;
  for (size_t i = 0; i < effect.parts.size(); ++i) {
    left -= effect.probabilities[i];
    for (Outcome outcome : OutcomesOf(effect.parts[i])) {
      outcome.probability *= effect.probabilities[i];
      outcomes.push_back(std::move(outcome));
    }
  }
  if (left > 1e-12) outcomes.push_back({left, {}, {}});
  return outcomes;
}

/// Of contradicting effects an addition counts, so additions come last.
std::string PpddlRule::Changes(const Outcome& outcome) {
  std::vector<std::string> changes;
  for (const std::string& atom : outcome.deleted) {
    if (std::ranges::find(outcome.added, atom) == outcome.added.end()) {
      changes.push_back("not " + atom);
    }
  }
  changes.insert(changes.end(), outcome.added.begin(), outcome.added.end());
  return changes.empty() ? "nothing"
                         : fmt::format("{}", fmt::join(changes, ", "));
}

}  // namespace cell::rexd
