#pragma once

#include <string>

#include "services/planner/attempts.h"
#include "services/planner/plan.h"

namespace cell {

/// The question to the person when there is no plan (sections VI-B1, IX-C): it
/// names what would have to be otherwise.
std::string AskForWishes(const Plan& no_plan, const State& state,
                         const Domain& domain);

/// The question for a step that has failed too often.
std::string AskAfterFailures(const GroundAction& action,
                             const Attempts::Entry& attempts,
                             const Domain& domain);

/// The question for a step that is the person's.
std::string AskForStep(const GroundAction& action, const Domain& domain);

}  // namespace cell
