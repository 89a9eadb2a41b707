#pragma once

#include <string>
#include <vector>

#include "services/cell/explaining/explanation.h"
#include "services/planner/decision_basis.h"

namespace cell::cli {

/// The expected actions and the probability that `chosen` has, and how the best
/// others compare. `is_verbose`: all others, and why those that lead nowhere or
/// are not possible do not come into question.
Reasons AlternativeReasons(const planner::DecisionBasis& basis,
                           const GroundAction& chosen, bool is_verbose);

/// "Insert(bolt_1, hole_1) has failed 3 times in this state, ...".
Reasons FailureReasons(const planner::DecisionBasis& basis);

}  // namespace cell::cli
