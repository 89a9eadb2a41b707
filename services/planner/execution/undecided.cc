#include "services/planner/execution/undecided.h"

#include "services/planner/execution/ask.h"
#include "services/planner/question.h"

namespace cell::planner {
namespace {

/// What a person could do about it.
ExecutionStatus QuestionAbout(const ExecutionContext& context,
                              const State& state) {
  const Plan& plan = context.plan.get();
  const RequestWords& requests = context.params.requests;
  if (plan.result == Plan::Result::kNoPlan) {
    return AskForHelp(context.plan, state, context.dispatch.failures(),
                      requests);
  }
  return {.state = ExecutionStatus::State::kStuck,
          .text = plan.result == Plan::Result::kFound
                      ? AskForView(plan.steps.at(0).action,
                                   context.plan.rules(), requests)
                      : plan.reason};
}

}  // namespace

NextState Undecided::Step(ExecutionContext& context, Instant now,
                          Decisions& out) {
  if (NextState next = PrerequisiteToWait(context, state_, now, out)) {
    return next;
  }
  if (!context.dialogue.IsPatient(now)) {
    return std::make_unique<Ask>(state_, QuestionAbout(context, state_));
  }
  context.sensing.Ask(now, context.params.sense_period_us, out);
  return nullptr;
}

}  // namespace cell::planner
