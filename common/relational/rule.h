#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/relational/literal.h"
#include "common/relational/skill.h"

namespace cell {

/// The agents that can do an action.
enum class Agent { kPerson, kRobot };

/// Literals that become true. With `each`, for every binding of these
/// variables for which `where` held before the action.
struct Effect {
  std::vector<Variable> each;
  std::vector<Literal> where;
  std::vector<Literal> then;
  bool operator==(const Effect&) const = default;
};

struct Outcome {
  double probability;
  std::vector<Effect> effects;
  bool operator==(const Outcome&) const = default;
};

/// A variable that stands for the one object for which all `literals` hold; if
/// there is none, or a second, the rule does not apply.
struct DeicticReference {
  Variable variable;
  std::vector<Literal> literals;
  bool operator==(const DeicticReference&) const = default;
};

/// Noisy deictic rule of an action (Pasula, Zettlemoyer, Kaelbling, JAIR 2007;
/// the paper's Fig. 10). Its variables are the action's arguments, then those
/// of the references, in their order, then those of an effect's `each`.
struct NdrRule {
  std::vector<Agent> agents;  ///< the agents that it holds for
  std::vector<DeicticReference> references;
  std::vector<Literal> context;
  std::vector<Outcome> outcomes;
  /// Probability that something not modelled happens; for planning: nothing.
  double noise = 0;
  /// That it was learned from and covers; 0: it was not learned here.
  int num_experiences = 0;

  bool IsFor(Agent agent) const;
  bool operator==(const NdrRule&) const = default;
};

/// An action with typed arguments and its rules. In each state at most one of
/// an agent's should cover it.
struct Action {
  std::string name;
  std::vector<Variable> arguments;
  std::vector<Agent> agents;
  std::optional<int> undoes;  ///< the action that it reverses
  std::vector<NdrRule> rules;
  std::optional<SkillBinding> skill;  ///< how an arm does it

  bool MayBeDoneBy(Agent agent) const;
  /// True if the arguments of both have the same types.
  bool TakesArgumentsOf(const Action& other) const;
  bool operator==(const Action&) const = default;
};

/// An action with its objects.
struct GroundAction {
  int action;
  Binding arguments;
  auto operator<=>(const GroundAction&) const = default;
};

/// A rule that covers a state, with all its variables bound.
struct ApplicableRule {
  int rule;
  Binding binding;
};

/// All rules of `action` for `agent` that may cover `state`, where some atoms
/// may be unknown (see MayHold). In a state without unknown atoms the rule
/// applies if it is the only one; if none or several may apply, the default
/// rule does: nothing changes.
std::vector<ApplicableRule> ApplicableRules(const Action& action,
                                            const Binding& arguments,
                                            const State& state,
                                            const Vocabulary& vocabulary,
                                            Agent agent);

/// The state after the outcome. Of contradicting effects the later one counts.
State Apply(const Outcome& outcome, const Binding& binding, const State& before,
            const Vocabulary& vocabulary);

/// Calls visit(effect, binding) for every effect of the outcome and every
/// binding of its `each`, whether or not its `where` holds in a state.
void ForEachEffect(
    const Outcome& outcome, const Binding& binding,
    const Vocabulary& vocabulary,
    const std::function<void(const Effect&, const Binding&)>& visit);

}  // namespace cell
