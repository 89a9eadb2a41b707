#pragma once

#include "services/planner/execution/execution_state.h"

namespace cell::planner {

/// Until all arms are at rest: what was asked for by the goal before, or before
/// the planner was started anew, may still be under way.
class AwaitRest final : public ExecutionState {
 public:
  std::string_view name() const override { return "await_rest"; }
  NextState Step(ExecutionContext& context, Instant now,
                 Decisions& out) override;
};

}  // namespace cell::planner
