#include "services/planner/execution/ask.h"

namespace cell::planner {

NextState Ask::Step(ExecutionContext& context, Instant now, Decisions& out) {
  if (NextState next = PrerequisiteToWait(context, state_, now, out)) {
    return next;
  }
  context.dialogue.Ask(question_, state_, now, out);
  context.sensing.Ask(now, context.params.watch_period_us, out);
  return nullptr;
}

}  // namespace cell::planner
