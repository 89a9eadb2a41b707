#pragma once

#include <string>
#include <utility>

#include "services/planner/execution/execution_state.h"

namespace cell::planner {

/// What a person takes apart afterwards stays so until there is another goal.
class Done final : public ExecutionState {
 public:
  explicit Done(std::string left_over) : left_over_(std::move(left_over)) {}

  std::string_view name() const override { return "done"; }
  NextState Step(ExecutionContext& context, Instant now,
                 Decisions& out) override;
  ExecutionStatus Status(const ExecutionContext& context) const override;

 private:
  std::string left_over_;  // what cleaning up could not do; empty: nothing
};

}  // namespace cell::planner
