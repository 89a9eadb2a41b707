#include "services/planner/execution/await_rest.h"

#include "services/planner/execution/await.h"

namespace cell::planner {

NextState AwaitRest::Step(ExecutionContext& context, Instant now, Decisions&) {
  if (!context.may_act || !context.dispatch.HaveArmsReported() ||
      !context.dispatch.AreArmsIdle()) {
    return nullptr;
  }
  context.sensing.RequireSince(now.utime);
  return std::make_unique<Await>();
}

}  // namespace cell::planner
