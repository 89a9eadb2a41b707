#pragma once

#include <utility>

#include "services/planner/execution/execution_state.h"

namespace cell::planner {

/// There is no plan, or none that is sure. For a while that may settle by
/// itself, as when a person is at work; then all is done that does not depend
/// on it, and the person is asked.
class Undecided final : public ExecutionState {
 public:
  explicit Undecided(State state) : state_(std::move(state)) {}

  std::string_view name() const override { return "undecided"; }
  NextState Step(ExecutionContext& context, Instant now,
                 Decisions& out) override;

 private:
  State state_;  // without a sure plan
};

}  // namespace cell::planner
