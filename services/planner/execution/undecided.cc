#include "services/planner/execution/undecided.h"

#include <set>
#include <utility>

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
  if (plan.result == Plan::Result::kNotLearned) {
    return AskForDemonstration(plan, context.plan.rules().vocabulary(),
                               requests);
  }
  if (plan.result == Plan::Result::kNoPlan) {
    ExecutionStatus question =
        AskForHelp(context.plan, state, context.dispatch.failures(), requests);
    if (context.params.sec_models) {
      OfferStandIns(*context.params.sec_models, context.plan.rules(), state,
                    &question);
    }
    return question;
  }
  return {.state = ExecutionStatus::State::kStuck,
          .text = plan.result == Plan::Result::kFound
                      ? AskForView(plan.steps.at(0).action,
                                   context.plan.rules(), requests)
                      : plan.reason};
}

/// What does not depend on a person's help, or is worth a try.
std::optional<GroundAction> ChooseMeanwhile(const ExecutionContext& context,
                                            const State& state) {
  const Plan::Result result = context.plan.get().result;
  const bool has_no_plan = result == Plan::Result::kNoPlan;
  if (!has_no_plan && result != Plan::Result::kNotLearned) return std::nullopt;
  const std::set<GroundAction> blocked = context.NotToBegin();
  std::optional<GroundAction> action;
  if (has_no_plan) action = StepMeanwhile(context.plan, state, blocked);
  if (!action && context.params.exploration) {
    action = StepWithoutPlan(context.plan, state, blocked,
                             *context.params.exploration);
  }
  return action;
}

/// The state that follows; nullptr if there is nothing to do.
NextState BeginMeanwhile(ExecutionContext& context, const State& state,
                         Instant now, Decisions& out) {
  if (!context.dispatch.running().empty()) return nullptr;
  const auto action = ChooseMeanwhile(context, state);
  const auto request = action ? context.RequestToArm(*action) : std::nullopt;
  if (!request || !context.dispatch.IsFree(request->arm)) return nullptr;
  NextState next = Act::BeginAction(context, *action, state, now, out);
  return next ? std::move(next) : std::make_unique<Act>();
}

}  // namespace

NextState Undecided::Step(ExecutionContext& context, Instant now,
                          Decisions& out) {
  if (NextState next = PrerequisiteToWait(context, state_, now, out)) {
    return next;
  }
  if (!context.dialogue.IsPatient(now)) {
    if (NextState next = BeginMeanwhile(context, state_, now, out)) return next;
    if (context.LeaveRoom(now, out)) return std::make_unique<Act>();
    return std::make_unique<Ask>(state_, QuestionAbout(context, state_));
  }
  context.sensing.Ask(now, context.params.sense_period_us, out);
  return nullptr;
}

}  // namespace cell::planner
