#pragma once

#include <string>

#include "services/planner/attempts.h"
#include "services/planner/plan_search.h"

namespace cell::planner {

/// The question to the person when there is no plan (sections VI-B1, IX-C): it
/// names what has failed too often, if all would be well without, or else what
/// would have to be otherwise. `unblocked` searches with all actions.
std::string AskForHelp(const Plan& no_plan, const State& state,
                       PlanSearch unblocked, const Attempts& attempts);

/// The question for a step that is the person's.
std::string AskForStep(const GroundAction& action, const Domain& domain);

}  // namespace cell::planner
