#pragma once

#include <string>

#include "common/relational/request_words.h"
#include "services/planner/current_plan.h"
#include "services/planner/execution_status.h"
#include "services/planner/failure_history.h"

namespace cell::planner {

// What the person is asked, in words of the task's domain where it has some.

/// The question when there is no plan (sections VI-B1, IX-C): it names what has
/// failed too often, if all would be well without, or else what the hands could
/// do so that there is a plan. @param plan  none was found for `state`
ExecutionStatus AskForHelp(const CurrentPlan& plan, const State& state,
                           const FailureHistory& failures,
                           const RequestWords& requests);

/// The question when some of the goal is not learned: "please show me one of
/// these, ...: put the bolt into hole_1; put ..."
ExecutionStatus AskForDemonstration(const Plan& not_learned,
                                    const Vocabulary& vocabulary,
                                    const RequestWords& requests);

/// "take away what lies over the lid; take out of hole_1 what is in it": what
/// would have to be done so that there is a plan; empty: nothing would help.
std::string WordsForChanges(const Plan& no_plan, const Vocabulary& vocabulary,
                            const RequestWords& requests);

/// "please put the lid on": the step is left to the person.
std::string AskForStep(const GroundAction& action, const RuleSet& rules,
                       const RequestWords& requests);

/// The question before an arm does for the first time what it has learned.
ExecutionStatus AskForConfirmation(const GroundAction& action,
                                   const RuleSet& rules);

/// The question when sensing cannot decide whether the next step is possible.
std::string AskForView(const GroundAction& action, const RuleSet& rules,
                       const RequestWords& requests);

}  // namespace cell::planner
