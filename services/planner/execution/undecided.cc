#include "services/planner/execution/undecided.h"

#include <set>

#include "services/planner/execution/act.h"
#include "services/planner/execution/ask.h"
#include "services/planner/meanwhile.h"
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

/// Does what does not depend on a person's help. False if there is nothing.
bool BeginMeanwhile(ExecutionContext& context, const State& state, Instant now,
                    Decisions& out) {
  if (context.plan.get().result != Plan::Result::kNoPlan ||
      !context.dispatch.running().empty()) {
    return false;
  }
  std::set<GroundAction> blocked = context.dispatch.failures().Blocked();
  blocked.insert(context.params.help_steps.begin(),
                 context.params.help_steps.end());
  const auto action = StepMeanwhile(context.plan, state, blocked);
  if (!action) return false;
  const auto request = context.RequestToArm(*action);
  if (!request || !context.dispatch.IsFree(request->arm)) return false;
  context.dispatch.Start(*request, *action, state, now, out);
  return true;
}

}  // namespace

NextState Undecided::Step(ExecutionContext& context, Instant now,
                          Decisions& out) {
  if (NextState next = PrerequisiteToWait(context, state_, now, out)) {
    return next;
  }
  if (!context.dialogue.IsPatient(now)) {
    if (BeginMeanwhile(context, state_, now, out)) {
      return std::make_unique<Act>();
    }
    return std::make_unique<Ask>(state_, QuestionAbout(context, state_));
  }
  context.sensing.Ask(now, context.params.sense_period_us, out);
  return nullptr;
}

}  // namespace cell::planner
