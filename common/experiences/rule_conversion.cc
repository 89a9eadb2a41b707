#include "common/experiences/rule_conversion.h"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/rules/rule_text.h"

namespace cell {
namespace {

/// Translates the literals of one rule, whose variables get types as they
/// appear. Remembers the first reason to refuse the rule.
class Translator {
 public:
  Translator(const rules::Rule& rule, const RuleWorld& world)
      : rule_(rule),
        scope_(rule),
        world_(world),
        types_(world.vocabulary().types()) {
    const Action& action =
        world.actions()[static_cast<size_t>(world.ActionOf(rule.action))];
    variables_ = action.arguments;
  }

  DeicticReference Reference(const rules::Reference& reference) {
    const int index = static_cast<int>(variables_.size());
    variables_.push_back({reference.variable, TypeHierarchy::kObject});
    for (const rules::Literal& literal : reference.literals) {
      Narrow(literal, index);
    }
    DeicticReference result{variables_.back(), {}};
    result.literals = Conditions(reference.literals);
    return result;
  }

  std::vector<Literal> Conditions(const std::vector<rules::Literal>& from) {
    std::vector<Literal> literals;
    for (const rules::Literal& literal : from) {
      if (!CheckKind(literal)) return {};
      const Match match = MatchTypes(literal);
      const bool is_negated = literal.comparison == rules::Comparison::kFalse;
      if (match == Match::kNever && is_negated) continue;
      if (match == Match::kNever) Refuse(literal, "can never hold");
      if (match == Match::kSometimes) {
        Refuse(literal, "is defined for some of the objects only");
      }
      literals.push_back(Translate(literal));
    }
    return literals;
  }

  /// Of contradicting effects the later one counts: that of a literal.
  Outcome ToOutcome(const rules::Outcome& outcome) {
    Outcome result{outcome.probability, {}};
    for (const rules::QuantifiedChange& each : outcome.each) {
      result.effects.push_back(ToEffect(each));
    }
    Effect effect;
    for (const rules::Literal& change : outcome.changes) {
      if (!CheckKind(change)) break;
      if (MatchTypes(change) != Match::kAlways) {
        Refuse(change, "changes what is not defined for all of the objects");
      }
      effect.then.push_back(Translate(change));
      if (effect.then.back().is_static) {
        Refuse(change, "changes a static fact");
      }
    }
    result.effects.push_back(std::move(effect));
    return result;
  }

  const std::optional<std::string>& refusal() const { return refusal_; }

 private:
  enum class Match { kNever, kSometimes, kAlways };

  /// The quantified variable has a type for as long as the effect is read.
  Effect ToEffect(const rules::QuantifiedChange& each) {
    const int index = static_cast<int>(variables_.size());
    variables_.push_back({each.variable, TypeHierarchy::kObject});
    scope_ = rule_.WithVariable(each.variable);
    NarrowByTerms(each.change, index);
    for (const rules::Literal& literal : each.where) Narrow(literal, index);
    Effect effect{{variables_.back()}, Conditions(each.where), {}};
    const Outcome change = ToOutcome({0, {each.change}});
    effect.then = change.effects.front().then;
    variables_.pop_back();
    scope_ = rule_;
    return effect;
  }

  void Refuse(const rules::Literal& literal, const std::string& why) {
    if (refusal_) return;
    refusal_ = fmt::format(
        "'{}' {}", rules::ToText(literal, scope_, world_.world()->symbols()),
        why);
  }

  bool CheckKind(const rules::Literal& literal) {
    if (literal.symbol == rules::Literal::kSame) {
      Refuse(literal, "asks whether two objects are the same");
    } else if (literal.comparison != rules::Comparison::kTrue &&
               literal.comparison != rules::Comparison::kFalse) {
      Refuse(literal, "compares numbers");
    }
    return !refusal_;
  }

  /// What the literal says about the type of the reference that it defines.
  void Narrow(const rules::Literal& literal, int variable) {
    if (literal.symbol == rules::Literal::kSame ||
        literal.comparison != rules::Comparison::kTrue) {
      return;
    }
    NarrowByTerms(literal, variable);
  }

  void NarrowByTerms(const rules::Literal& literal, int variable) {
    int& type = variables_[static_cast<size_t>(variable)].type;
    const auto narrow = [&](int other) {
      if (types_.IsA(other, type)) type = other;
    };
    const std::string& name = world_.world()->symbols()[literal.symbol].name;
    const auto& arguments = world_.ArgumentTypes(literal.symbol);
    for (size_t i = 0; i < literal.terms.size(); ++i) {
      if (literal.terms[i].kind != rules::Term::Kind::kVariable ||
          literal.terms[i].index != variable) {
        continue;
      }
      narrow(arguments[i]);
      if (literal.terms.size() == 1 && types_.Find(name)) {
        narrow(*types_.Find(name));
      }
    }
  }

  /// Whether the literal's relation is defined for its terms.
  Match MatchTypes(const rules::Literal& literal) const {
    const std::vector<int>& wanted = world_.ArgumentTypes(literal.symbol);
    Match match = Match::kAlways;
    for (size_t i = 0; i < literal.terms.size(); ++i) {
      const std::optional<int> type = TypeOf(literal.terms[i]);
      if (!type || types_.IsA(*type, wanted[i])) continue;
      if (!types_.IsA(wanted[i], *type)) return Match::kNever;
      match = Match::kSometimes;
    }
    return match;
  }

  std::optional<int> TypeOf(const rules::Term& term) const {
    switch (term.kind) {
      case rules::Term::Kind::kVariable:
        return variables_[static_cast<size_t>(term.index)].type;
      case rules::Term::Kind::kObject:
        return world_.vocabulary()
            .objects()[static_cast<size_t>(world_.ObjectOf(term.index))]
            .type;
      case rules::Term::Kind::kAny:
        break;
    }
    return std::nullopt;
  }

  Literal Translate(const rules::Literal& from) const {
    Literal literal;
    const auto predicate = world_.PredicateOf(from.symbol);
    literal.is_static = !predicate;
    literal.relation = predicate ? *predicate : *world_.StaticOf(from.symbol);
    literal.is_negated = from.comparison == rules::Comparison::kFalse;
    for (const rules::Term& term : from.terms) {
      Term& to = literal.terms.emplace_back();
      if (term.kind == rules::Term::Kind::kVariable) {
        to = {Term::Kind::kVariable, term.index};
      } else if (term.kind == rules::Term::Kind::kObject) {
        to = {Term::Kind::kObject, world_.ObjectOf(term.index)};
      }
    }
    return literal;
  }

  const rules::Rule& rule_;
  rules::Rule scope_;  // whose variables literals name
  const RuleWorld& world_;
  const TypeHierarchy& types_;
  std::vector<Variable> variables_;
  std::optional<std::string> refusal_;
};

}  // namespace

Result<NdrRule> ToNdrRule(const rules::Rule& rule, const RuleWorld& world) {
  Translator translator(rule, world);
  NdrRule result;
  result.agents =
      world.actions()[static_cast<size_t>(world.ActionOf(rule.action))].agents;
  for (const rules::Reference& reference : rule.references) {
    result.references.push_back(translator.Reference(reference));
  }
  result.context = translator.Conditions(rule.context);
  for (const rules::Outcome& outcome : rule.outcomes) {
    result.outcomes.push_back(translator.ToOutcome(outcome));
  }
  result.noise = rule.noise;
  if (translator.refusal()) {
    return Reason{fmt::format("a rule of {}: {}",
                              world.world()->symbols()[rule.action].name,
                              *translator.refusal())};
  }
  return result;
}

Result<std::vector<Action>> WithLearnedRules(const rules::NdrRules& rules,
                                             const RuleWorld& world) {
  std::vector<Action> actions = world.actions();
  std::set<int> learned;
  for (const rules::Rule& rule : rules.rules) {
    const int index = world.ActionOf(rule.action);
    Action& action = actions[static_cast<size_t>(index)];
    if (learned.insert(index).second) action.rules.clear();
    const auto converted = ToNdrRule(rule, world);
    if (!converted) return Reason{converted.reason()};
    action.rules.push_back(*converted);
  }
  return actions;
}

}  // namespace cell
