#pragma once

#include <string>
#include <vector>

#include "common/relational/rule_gap.h"
#include "services/cell/explaining/explanation.h"
#include "services/planner/solver.h"

namespace cell::cli {

/// The rule that covers the action in the state, with its objects; all that may
/// if something is unknown.
Reasons CoveringRules(const planner::Problem& problem,
                      const GroundAction& action, const State& state);

/// The rule that needs the change of the state for the action, and what else
/// it lacks; empty if there is none.
Reasons RuleThatNeeds(const planner::Problem& problem,
                      const GroundAction& action, const State& state,
                      const planner::RequiredChange& change);

/// The rule that lacks least to cover the action in the state; empty if it has
/// none.
Reasons NearestRule(const planner::Problem& problem, const GroundAction& action,
                    const State& state);

/// "needs not On(_, a)": why the action changes nothing in the state.
std::string WhyNotPossible(const planner::Problem& problem,
                           const GroundAction& action, const State& state);

}  // namespace cell::cli
