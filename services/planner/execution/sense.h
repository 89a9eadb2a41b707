#pragma once

#include "services/planner/execution/execution_state.h"

namespace cell::planner {

/// Until a state was sensed that shows all that was done.
class Sense final : public ExecutionState {
 public:
  std::string_view name() const override { return "sense"; }
  NextState Step(ExecutionContext& context, Instant now,
                 Decisions& out) override;
};

}  // namespace cell::planner
