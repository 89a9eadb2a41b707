#pragma once

#include "services/planner/execution/execution_state.h"

namespace cell::planner {

/// Until all arms are at rest: skills requested for the previous goal, or
/// before the planner was restarted, may still run.
class AwaitRest final : public ExecutionState {
 public:
  std::string_view name() const override { return "await_rest"; }
  NextState Step(ExecutionContext& context, Instant now,
                 Decisions& out) override;
};

}  // namespace cell::planner
