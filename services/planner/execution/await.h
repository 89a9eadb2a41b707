#pragma once

#include "services/planner/execution/execution_state.h"

namespace cell::planner {

/// Until an arm may begin something: the mode allows it, all arms have reported
/// since the last skill ended, those with an interrupted skill have gone free,
/// and one has nothing to do.
class Await final : public ExecutionState {
 public:
  std::string_view name() const override { return "await"; }
  NextState Step(ExecutionContext& context, Instant now,
                 Decisions& out) override;
};

}  // namespace cell::planner
