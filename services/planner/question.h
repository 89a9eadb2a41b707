#pragma once

#include <string>

#include "services/planner/current_plan.h"
#include "services/planner/failure_history.h"

namespace cell::planner {

/// The question to the person when there is no plan (sections VI-B1, IX-C): it
/// names what has failed too often, if all would be well without, or else what
/// would have to be otherwise. @param plan  none was found for `state`
std::string AskForHelp(const CurrentPlan& plan, const State& state,
                       const FailureHistory& failures);

/// The question for a step that is left to the person.
std::string AskForStep(const GroundAction& action, const RuleSet& rules);

}  // namespace cell::planner
