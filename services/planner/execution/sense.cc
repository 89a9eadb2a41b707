#include "services/planner/execution/sense.h"

#include "services/planner/execution/act.h"
#include "services/planner/execution/await.h"

namespace cell::planner {

NextState Sense::Step(ExecutionContext& context, Instant now, Decisions& out) {
  if (!context.MayBegin(now, out) || !context.dispatch.HasFreeArm()) {
    return std::make_unique<Await>();
  }
  if (context.sensing.Fresh() != nullptr) return std::make_unique<Act>();
  if (context.sensing.IsDue(now)) {
    context.sensing.Ask(now, context.params.sense_period_us, out);
  }
  return nullptr;
}

}  // namespace cell::planner
