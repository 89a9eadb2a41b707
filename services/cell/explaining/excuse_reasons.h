#pragma once

#include <string>
#include <vector>

#include "services/cell/explaining/explanation.h"
#include "services/planner/decision_basis.h"

namespace cell::cli {

/// True if no plan leads to the goal, or nobody has shown how.
bool HasNoPlan(const planner::Plan& plan);

/// Why `no_plan` of the state is none: what nobody has shown; or else the
/// excuse (section VI-B1), the rules whose preconditions are missing, and the
/// plan that there would be.
Reasons NoPlanReasons(const planner::DecisionBasis& basis, const State& state,
                      const planner::Plan& no_plan);

/// The question that the robot asks.
Reasons QuestionReasons(const planner::DecisionBasis& basis,
                        const planner::ExecutionStatus& question,
                        bool is_verbose);

/// "9.00 actions expected: Insert(bolt_1, hole_1), Close(lid)".
std::string PlanText(const planner::Plan& plan, const RuleSet& rules);

}  // namespace cell::cli
