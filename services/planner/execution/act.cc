#include "services/planner/execution/act.h"

#include <algorithm>

#include "services/planner/execution/ask.h"
#include "services/planner/execution/await_person.h"
#include "services/planner/execution/clean_up.h"
#include "services/planner/execution/undecided.h"
#include "services/planner/outcome_prediction.h"
#include "services/planner/question.h"

namespace cell::planner {
namespace {

/// True if it neither concerns the objects of the other arms' skills nor keeps
/// those skills from being possible.
bool IsIndependent(const GroundAction& action, const SkillRequest& request,
                   const ExecutionContext& context) {
  return std::ranges::all_of(
      context.dispatch.running(), [&](const auto& entry) {
        const RunningSkill& other = entry.second;
        return other.action && !ShareAnObject(other.request, request) &&
               AreIndependent(context.plan.rules(), action, *other.action,
                              other.before);
      });
}

bool MayHandOver(const GroundAction& action, const SkillRequest& request,
                 const ExecutionContext& context, const State& state) {
  const SkillTraits* traits =
      context.dispatch.arms().TraitsOf(request.arm, request.skill);
  // Out of its turn another skill could undo what an earlier step needs.
  return traits != nullptr && traits->may_run_beside && traits->hands_over &&
         context.dispatch.IsFree(request.arm) &&
         !context.dispatch.failures().Blocked().contains(action) &&
         IsSurelyPossible(context.plan.rules(), action, state) &&
         IsIndependent(action, request, context);
}

}  // namespace

NextState Act::Step(ExecutionContext& context, Instant now, Decisions& out) {
  if (NextState first = Prerequisite(context, now, out)) return first;
  const State state = context.StateNow();
  // While something is under way the state may look odd: no new plan for it.
  if (!context.dispatch.running().empty()) {
    HandOver(context, state, now, out);
    return nullptr;
  }
  if (context.dialogue.IsPersonAtWork(state, now)) {
    return std::make_unique<AwaitPerson>();
  }
  if (now.utime < context.lesson_utime) return nullptr;
  context.dispatch.failures().Update(state);
  const Plan& plan =
      context.plan.Find(state, context.dispatch.failures().Blocked());
  if (auto changed = context.plan.TakeIfNew(*context.sensing.Fresh())) {
    out.plan = std::move(changed);
  }
  if (context.params.exploration && plan.result != Plan::Result::kGoalReached) {
    const auto action =
        LeastTried(context.plan.rules(), state, context.NotToBegin(),
                   context.params.exploration->known_count);
    if (action) return BeginAction(context, *action, state, now, out);
  }
  switch (plan.result) {
    case Plan::Result::kFound:
      return Begin(context, state, now, out);
    case Plan::Result::kGoalReached:
      context.dialogue.OnStart();
      return std::make_unique<CleanUp>(context.params.dispatch.max_attempts);
    default:
      return std::make_unique<Undecided>(state);
  }
}

NextState Act::Begin(ExecutionContext& context, const State& state, Instant now,
                     Decisions& out) {
  const RuleSet& rules = context.plan.rules();
  const GroundAction& action = context.plan.get().steps.at(0).action;
  if (!context.RequestToArm(action)) {
    return std::make_unique<Ask>(
        state, ExecutionStatus{
                   .state = ExecutionStatus::State::kStuck,
                   .text = AskForStep(action, rules, context.params.requests),
                   .step = action});
  }
  if (!IsSurelyPossible(rules, action, state)) {
    return std::make_unique<Undecided>(state);
  }
  return BeginAction(context, action, state, now, out);
}

/// An operator has to let arms do what is new to them.
NextState Act::BeginAction(ExecutionContext& context,
                           const GroundAction& action, const State& state,
                           Instant now, Decisions& out) {
  const auto request = context.RequestToArm(action);
  if (!request || !context.dispatch.IsFree(request->arm)) return nullptr;
  if (context.AwaitsConfirmation(action)) {
    return std::make_unique<Ask>(
        state, AskForConfirmation(action, context.plan.rules()));
  }
  context.Start(*request, action, state, now, out);
  HandOver(context, state, now, out);
  return nullptr;
}

/// Lets another arm hand over what the plan needs later.
void Act::HandOver(ExecutionContext& context, const State& state, Instant now,
                   Decisions& out) {
  if (!context.params.parallel) return;
  for (const PlanStep& step : context.plan.get().steps) {
    const auto request = context.RequestToArm(step.action);
    if (!request || !MayHandOver(step.action, *request, context, state)) {
      continue;
    }
    context.Start(*request, step.action, state, now, out);
  }
}

}  // namespace cell::planner
