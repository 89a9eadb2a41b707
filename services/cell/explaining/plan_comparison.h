#pragma once

#include <string>
#include <vector>

#include "services/cell/explaining/explanation.h"
#include "services/planner/decision_basis.h"
#include "services/planner/judgement.h"

namespace cell::cli {

/// What a person's action has changed, the plans before and after it, and why
/// the steps that have been added are necessary; or the excuse of no plan.
Reasons ComparePlans(const planner::DecisionBasis& basis,
                     const planner::Judgement& judgement);

}  // namespace cell::cli
