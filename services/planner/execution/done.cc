#include "services/planner/execution/done.h"

namespace cell::planner {

NextState Done::Step(ExecutionContext&, Instant, Decisions&) {
  return nullptr;
}

ExecutionStatus Done::Status(const ExecutionContext&) const {
  return {.state = ExecutionStatus::State::kDone, .text = left_over_};
}

}  // namespace cell::planner
