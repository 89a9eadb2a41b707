#include "services/planner/execution/await.h"

#include "services/planner/execution/sense.h"

namespace cell::planner {

NextState Await::Step(ExecutionContext& context, Instant now, Decisions& out) {
  if (!context.MayBegin(now, out) || !context.dispatch.HasFreeArm()) {
    return nullptr;
  }
  return std::make_unique<Sense>();
}

}  // namespace cell::planner
