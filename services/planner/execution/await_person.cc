#include "services/planner/execution/await_person.h"

#include "services/planner/execution/act.h"

namespace cell::planner {

NextState AwaitPerson::Step(ExecutionContext& context, Instant now,
                            Decisions& out) {
  if (NextState first = Prerequisite(context, now, out)) return first;
  if (!context.dialogue.IsPersonAtWork(context.StateNow(), now)) {
    return std::make_unique<Act>();
  }
  context.sensing.Ask(now, context.params.watch_period_us, out);
  return nullptr;
}

}  // namespace cell::planner
