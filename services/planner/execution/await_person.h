#pragma once

#include "services/planner/execution/execution_state.h"

namespace cell::planner {

/// The person is at what was asked for: until the state stays as it is, or the
/// person was seen to have let go.
class AwaitPerson final : public ExecutionState {
 public:
  std::string_view name() const override { return "await_person"; }
  NextState Step(ExecutionContext& context, Instant now,
                 Decisions& out) override;
};

}  // namespace cell::planner
