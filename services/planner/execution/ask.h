#pragma once

#include <utility>

#include "services/planner/execution/execution_state.h"

namespace cell::planner {

/// The person is asked for a change of the state, or for a step, until there is
/// another plan.
class Ask final : public ExecutionState {
 public:
  Ask(State state, ExecutionStatus question)
      : state_(std::move(state)), question_(std::move(question)) {}

  std::string_view name() const override { return "ask"; }
  NextState Step(ExecutionContext& context, Instant now,
                 Decisions& out) override;

 private:
  State state_;  // that the question is about
  ExecutionStatus question_;
};

}  // namespace cell::planner
