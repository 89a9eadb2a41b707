#include "common/planning/ground_ppddl.h"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "common/planning/alternatives.h"
#include "common/planning/ppddl_bindings.h"
#include "common/planning/ppddl_conditions.h"
#include "common/planning/reachability.h"

namespace cell::planning {
namespace {

using ppddl::Effect;

constexpr int64_t kMaxBindings = 50'000'000;

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
        limits_(limits),
        conditions_(world_, limits) {}

  GroundTask Ground() {
    for (const ppddl::Action& action : world_.domain().actions) {
      const bool is_done = ForEachBinding(
          world_, action, kMaxBindings,
          [&](const Objects& objects) { AddAction(action, objects); });
      if (!is_done) {
        throw TooLarge{
            fmt::format("{} has more than {} combinations of objects; {}",
                        action.name, kMaxBindings, kNarrower)};
      }
    }
    conditions_.Begin("the goal");
    task_.goals = conditions_.Normalize(problem_.goal, true, {});
    task_.atoms = conditions_.atoms();
    task_.initial = conditions_.initial();
    if (constants_ == ConstantAtoms::kReplace) {
      RemoveUnreachable(&task_);
      RemoveUnusedAtoms(&task_);
    }
    return std::move(task_);
  }

 private:
  void AddAction(const ppddl::Action& action, const Objects& objects) {
    conditions_.Begin(action.name);
    const Alternatives preconditions =
        conditions_.Normalize(action.precondition, true, objects);
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
                        limits_.max_actions, action.name, kNarrower)};
      }
    }
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
    const std::optional<int> atom =
        conditions_.AtomOf(effect.symbol, effect.terms, binding);
    if (!atom) return {{1, {}}};
    return {{1, {{{}, {{*atom, effect.kind == Effect::Kind::kAdd}}}}}};
  }

  std::vector<Outcome> AllOf(const Effect& effect, const Objects& binding) {
    std::vector<Outcome> joint = {{1, {}}};
    for (const Effect& part : effect.parts) {
      joint = Product(joint, OutcomesOf(part, binding));
    }
    return joint;
  }

  std::vector<Outcome> ForAll(const Effect& effect, const Objects& binding) {
    conditions_.CountInstances(effect.variables);
    std::vector<Outcome> joint = {{1, {}}};
    ForEachExtension(
        world_, effect.variables, binding, [&](const Objects& extended) {
          joint = Product(joint, OutcomesOf(effect.parts[0], extended));
        });
    return joint;
  }

  std::vector<Outcome> When(const Effect& effect, const Objects& binding) {
    const Alternatives when =
        conditions_.Normalize(effect.condition, true, binding);
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
          conditions_.where(), limits_.max_outcomes)};
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
  PpddlConditions conditions_;
  GroundTask task_;
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
