#include "common/planning/ground_ppddl.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "common/planning/alternatives.h"
#include "common/planning/ppddl_bindings.h"
#include "common/planning/reachability.h"

namespace cell::planning {
namespace {

using ppddl::Condition;
using ppddl::Effect;

constexpr int64_t kMaxBindings = 50'000'000;
constexpr int64_t kMaxInstances = 1'000'000;
constexpr const char* kAdvice =
    "give parameters narrower types or static conditions";

/// What exceeds the limits; caught by GroundPpddl().
struct TooLarge {
  std::string text;
};

/// The effects of an outcome, deletions before additions: of contradicting
/// effects an addition counts.
std::vector<ConditionalEffect> InOrder(
    const std::vector<ConditionalEffect>& effects) {
  std::vector<ConditionalEffect> ordered;
  for (const bool value : {false, true}) {
    ConditionalEffect plain;
    std::vector<ConditionalEffect> conditional;
    for (const ConditionalEffect& effect : effects) {
      if (effect.then.front().value != value) continue;
      if (effect.when == Conjunction{}) {
        plain.then.insert(plain.then.end(), effect.then.begin(),
                          effect.then.end());
      } else {
        conditional.push_back(effect);
      }
    }
    if (!plain.then.empty()) ordered.push_back(std::move(plain));
    ordered.insert(ordered.end(), conditional.begin(), conditional.end());
  }
  return ordered;
}

class Grounder {
 public:
  Grounder(const ppddl::Domain& domain, const ppddl::Problem& problem,
           ConstantAtoms constants, const GroundingLimits& limits)
      : world_(domain, problem, constants == ConstantAtoms::kReplace),
        problem_(problem),
        constants_(constants),
        limits_(limits) {}

  GroundTask Ground() {
    for (const ppddl::Action& action : world_.domain().actions) {
      const bool is_done = ForEachBinding(
          world_, action, kMaxBindings,
          [&](const Objects& objects) { AddAction(action, objects); });
      if (!is_done) {
        throw TooLarge{
            fmt::format("{} has more than {} combinations of objects; {}",
                        action.name, kMaxBindings, kAdvice)};
      }
    }
    where_ = "the goal";
    task_.goals = Normalize(problem_.goal, true, {});
    if (constants_ == ConstantAtoms::kReplace) {
      RemoveUnreachable(&task_);
      RemoveUnusedAtoms(&task_);
    }
    return std::move(task_);
  }

 private:
  void AddAction(const ppddl::Action& action, const Objects& objects) {
    where_ = action.name;
    const Alternatives preconditions =
        Normalize(action.precondition, true, objects);
    if (preconditions.empty()) return;
    std::vector<Outcome> outcomes = OutcomesOf(action.effect, objects);
    for (Outcome& outcome : outcomes) {
      outcome.effects = InOrder(outcome.effects);
    }
    GroundAtom name{action.name, {}};
    for (const int object : objects) {
      name.objects.push_back(world_.NameOf(object));
    }
    for (const Conjunction& precondition : preconditions) {
      task_.actions.push_back({Show(name), precondition, outcomes});
      if (static_cast<int64_t>(task_.actions.size()) > limits_.max_actions) {
        throw TooLarge{
            fmt::format("there are more than {} ground actions, at {}; {}",
                        limits_.max_actions, where_, kAdvice)};
      }
    }
  }

  void CheckSize(const Alternatives& alternatives) const {
    if (static_cast<int>(alternatives.size()) > limits_.max_alternatives) {
      throw TooLarge{fmt::format(
          "a condition of {} has more than {} alternatives; split it", where_,
          limits_.max_alternatives)};
    }
  }

  void CheckInstances(const std::vector<ppddl::Variable>& variables) const {
    double product = 1;
    for (const ppddl::Variable& variable : variables) {
      product *= static_cast<double>(world_.ObjectsOf(variable.type).size());
    }
    if (product > kMaxInstances) {
      throw TooLarge{
          fmt::format("a quantifier of {} has more than {} instances; {}",
                      where_, kMaxInstances, kAdvice)};
    }
  }

  /// Nothing if an object is of a wrong type: such an atom is never true.
  int AtomOf(int predicate, const std::vector<ppddl::Term>& terms,
             const Objects& binding, bool* is_valid) {
    ppddl::GroundAtom atom{predicate, {}};
    const auto& parameters =
        world_.domain().predicates[static_cast<size_t>(predicate)].parameters;
    *is_valid = true;
    for (size_t i = 0; i < terms.size(); ++i) {
      atom.objects.push_back(ObjectOf(terms[i], binding));
      *is_valid &= world_.IsOf(atom.objects.back(), parameters[i].type);
    }
    return *is_valid ? Intern(atom) : 0;
  }

  int Intern(const ppddl::GroundAtom& atom) {
    const auto [it, is_new] =
        index_of_.try_emplace(atom, static_cast<int>(task_.atoms.size()));
    if (is_new) {
      const auto& predicates = world_.domain().predicates;
      GroundAtom shown{predicates[static_cast<size_t>(atom.predicate)].name,
                       {}};
      for (const int object : atom.objects) {
        shown.objects.push_back(world_.NameOf(object));
      }
      task_.atoms.push_back(std::move(shown));
      task_.initial.push_back(world_.HoldsAtFirst(atom));
    }
    return it->second;
  }

  /// The atom, or its negation.
  Alternatives NormalizeAtom(const Condition& condition, bool value,
                             const Objects& binding) {
    if (world_.IsStatic(condition.predicate)) {
      ppddl::GroundAtom atom{condition.predicate, {}};
      for (const ppddl::Term& term : condition.terms) {
        atom.objects.push_back(ObjectOf(term, binding));
      }
      return world_.HoldsAtFirst(atom) == value ? True() : False();
    }
    bool is_valid = false;
    const int atom =
        AtomOf(condition.predicate, condition.terms, binding, &is_valid);
    if (!is_valid) return value ? False() : True();
    return {Conjunction{{{atom, value}}, {}}};
  }

  /// The conditions that hold if `condition` has the value.
  Alternatives Normalize(const Condition& condition, bool value,
                         const Objects& binding) {
    using enum Condition::Kind;
    switch (condition.kind) {
      case kAtom:
        return NormalizeAtom(condition, value, binding);
      case kEqual:
        return (ObjectOf(condition.terms[0], binding) ==
                ObjectOf(condition.terms[1], binding)) == value
                   ? True()
                   : False();
      case kNot:
        return Normalize(condition.parts[0], !value, binding);
      case kImply:
        return Join(value == false,
                    {Normalize(condition.parts[0], !value, binding),
                     Normalize(condition.parts[1], value, binding)});
      case kAnd:
      case kOr:
        return Join((condition.kind == kAnd) == value,
                    PartsOf(condition, value, binding));
      case kForall:
      case kExists:
        return Join((condition.kind == kForall) == value,
                    InstancesOf(condition, value, binding));
    }
    return {};
  }

  std::vector<Alternatives> PartsOf(const Condition& condition, bool value,
                                    const Objects& binding) {
    std::vector<Alternatives> parts;
    for (const Condition& part : condition.parts) {
      parts.push_back(Normalize(part, value, binding));
    }
    return parts;
  }

  std::vector<Alternatives> InstancesOf(const Condition& condition, bool value,
                                        const Objects& binding) {
    CheckInstances(condition.variables);
    std::vector<Alternatives> instances;
    ForEachExtension(
        world_, condition.variables, binding, [&](const Objects& extended) {
          instances.push_back(Normalize(condition.parts[0], value, extended));
        });
    return instances;
  }

  /// All of the parts, or one of them.
  Alternatives Join(bool all, const std::vector<Alternatives>& parts) const {
    Alternatives joint = all ? True() : False();
    for (const Alternatives& part : parts) {
      if (!all && part == True()) return True();
      if (all) {
        joint = Both(joint, part);
      } else {
        joint = joint.empty() ? part : Either(std::move(joint), part);
      }
      CheckSize(joint);
    }
    return joint;
  }

  std::vector<Outcome> OutcomesOf(const Effect& effect,
                                  const Objects& binding) {
    using enum Effect::Kind;
    switch (effect.kind) {
      case kAdd:
      case kDelete:
        return ChangeOf(effect, binding);
      case kAnd:
        return AllOf(effect, binding);
      case kForall:
        return ForAll(effect, binding);
      case kWhen:
        return When(effect, binding);
      case kProbabilistic:
        return OneOf(effect, binding);
      case kIncrease:
      case kDecrease:
        break;
    }
    return {{1, {}}};
  }

  std::vector<Outcome> ChangeOf(const Effect& effect, const Objects& binding) {
    bool is_valid = false;
    const int atom = AtomOf(effect.symbol, effect.terms, binding, &is_valid);
    if (!is_valid) return {{1, {}}};
    return {{1, {{{}, {{atom, effect.kind == Effect::Kind::kAdd}}}}}};
  }

  std::vector<Outcome> AllOf(const Effect& effect, const Objects& binding) {
    std::vector<Outcome> joint = {{1, {}}};
    for (const Effect& part : effect.parts) {
      joint = Product(joint, OutcomesOf(part, binding));
    }
    return joint;
  }

  std::vector<Outcome> ForAll(const Effect& effect, const Objects& binding) {
    CheckInstances(effect.variables);
    std::vector<Outcome> joint = {{1, {}}};
    ForEachExtension(
        world_, effect.variables, binding, [&](const Objects& extended) {
          joint = Product(joint, OutcomesOf(effect.parts[0], extended));
        });
    return joint;
  }

  std::vector<Outcome> When(const Effect& effect, const Objects& binding) {
    const Alternatives when = Normalize(effect.condition, true, binding);
    std::vector<Outcome> outcomes = OutcomesOf(effect.parts[0], binding);
    for (Outcome& outcome : outcomes) {
      std::vector<ConditionalEffect> effects;
      for (const ConditionalEffect& inner : outcome.effects) {
        for (const Conjunction& both : Both(when, {inner.when})) {
          effects.push_back({both, inner.then});
        }
      }
      outcome.effects = std::move(effects);
    }
    return outcomes;
  }

  std::vector<Outcome> OneOf(const Effect& effect, const Objects& binding) {
    std::vector<Outcome> outcomes;
    double rest = 1;
    for (size_t i = 0; i < effect.parts.size(); ++i) {
      for (Outcome& outcome : OutcomesOf(effect.parts[i], binding)) {
        outcome.probability *= effect.probabilities[i];
        if (outcome.probability > 0) outcomes.push_back(std::move(outcome));
      }
      rest -= effect.probabilities[i];
    }
    if (rest > 1e-12) outcomes.push_back({rest, {}});
    return outcomes;
  }

  /// Outcomes of independent effects.
  std::vector<Outcome> Product(const std::vector<Outcome>& a,
                               const std::vector<Outcome>& b) const {
    if (static_cast<int64_t>(a.size()) * static_cast<int64_t>(b.size()) >
        limits_.max_outcomes) {
      throw TooLarge{fmt::format(
          "{} has more than {} outcomes: independent probabilistic effects "
          "multiply",
          where_, limits_.max_outcomes)};
    }
    std::vector<Outcome> product;
    for (const Outcome& left : a) {
      for (const Outcome& right : b) {
        Outcome joint{left.probability * right.probability, left.effects};
        joint.effects.insert(joint.effects.end(), right.effects.begin(),
                             right.effects.end());
        product.push_back(std::move(joint));
      }
    }
    return product;
  }

  PpddlWorld world_;
  const ppddl::Problem& problem_;
  ConstantAtoms constants_;
  GroundingLimits limits_;
  GroundTask task_;
  std::map<ppddl::GroundAtom, int> index_of_;
  std::string where_;  // what is grounded, for errors
};

}  // namespace

Result<GroundTask> GroundPpddl(const ppddl::Domain& domain,
                               const ppddl::Problem& problem,
                               ConstantAtoms constants,
                               const GroundingLimits& limits) {
  try {
    return Grounder(domain, problem, constants, limits).Ground();
  } catch (const TooLarge& too_large) {
    return Reason{too_large.text};
  }
}

}  // namespace cell::planning
