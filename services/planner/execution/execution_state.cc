#include "services/planner/execution/execution_state.h"

#include "services/planner/execution/act.h"
#include "services/planner/execution/await.h"
#include "services/planner/execution/await_person.h"
#include "services/planner/execution/sense.h"

namespace cell::planner {

NextState Prerequisite(ExecutionContext& context, Instant now, Decisions& out) {
  if (!context.MayBegin(now, out) || !context.dispatch.HasFreeArm()) {
    return std::make_unique<Await>();
  }
  if (context.sensing.Fresh() == nullptr) return std::make_unique<Sense>();
  return nullptr;
}

NextState PrerequisiteToWait(ExecutionContext& context, const State& waits_in,
                             Instant now, Decisions& out) {
  if (NextState first = Prerequisite(context, now, out)) return first;
  const State state = context.StateNow();
  if (context.dialogue.IsPersonAtWork(state, now)) {
    return std::make_unique<AwaitPerson>();
  }
  const auto blocked = context.dispatch.failures().Blocked();
  if (state != waits_in || !context.plan.IsFor(state, blocked)) {
    return std::make_unique<Act>();
  }
  return nullptr;
}

}  // namespace cell::planner
