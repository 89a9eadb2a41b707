#include "services/planner/execution/undecided.h"

#include "services/planner/execution/ask.h"
#include "services/planner/question.h"

namespace cell::planner {
namespace {

/// What a person could do about it.
ExecutionStatus QuestionAbout(const ExecutionContext& context,
                              const State& state) {
  const Plan& plan = context.plan.get();
  ExecutionStatus question{.state = ExecutionStatus::State::kStuck};
  if (plan.result == Plan::Result::kNoPlan) {
    question = AskForHelp(context.plan, state, context.dispatch.failures(),
                          context.params.requests);
  } else if (plan.result == Plan::Result::kFound) {
    question.text = AskForView(plan.steps.at(0).action, context.plan.rules(),
                               context.params.requests);
  } else {
    question.text = plan.reason;
  }
  return question;
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
