#pragma once

#include "services/planner/execution/execution_state.h"

namespace cell::planner {

/// Plans from the fresh state, and asks the free arms for what the plan begins
/// with. While one arm works, others may hand over what the plan needs later.
class Act final : public ExecutionState {
 public:
  std::string_view name() const override { return "act"; }
  NextState Step(ExecutionContext& context, Instant now,
                 Decisions& out) override;

  /// What comes after asking for the action, which must be possible now, if the
  /// arm is free and may do it; nullptr: Act.
  static NextState BeginAction(ExecutionContext& context,
                               const GroundAction& action, const State& state,
                               Instant now, Decisions& out);

 private:
  /// Of a plan to the goal.
  static NextState Begin(ExecutionContext& context, const State& state,
                         Instant now, Decisions& out);
  static void HandOver(ExecutionContext& context, const State& state,
                       Instant now, Decisions& out);
};

}  // namespace cell::planner
