#pragma once

#include "services/planner/execution/execution_state.h"

namespace cell::planner {

/// Until all arms are at rest: what an earlier life of the planner, or the goal
/// before, has asked for may still be under way.
class AwaitRest final : public ExecutionState {
 public:
  std::string_view name() const override { return "await_rest"; }
  NextState Step(ExecutionContext& context, Instant now,
                 Decisions& out) override;
};

}  // namespace cell::planner
