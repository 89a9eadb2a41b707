#pragma once

#include <optional>

#include "common/relational/rule_set.h"

namespace cell::planner {

/// The state after the likeliest outcome of the agent's action; nullopt if no
/// rule covers `state`, or several do.
std::optional<State> MostLikelyOutcome(const RuleSet& rules,
                                       const GroundAction& action,
                                       const State& state,
                                       Agent agent = Agent::kRobot);

/// True if the robot's action is possible in `state` whatever its unknown
/// atoms are.
bool IsSurelyPossible(const RuleSet& rules, const GroundAction& action,
                      const State& state);

/// True if both actions are possible in `state`, and each after the other.
bool AreIndependent(const RuleSet& rules, const GroundAction& a,
                    const GroundAction& b, const State& state);

}  // namespace cell::planner
