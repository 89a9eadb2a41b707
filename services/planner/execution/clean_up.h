#pragma once

#include <map>
#include <set>
#include <string>

#include "services/planner/execution/execution_state.h"

namespace cell::planner {

/// The goal is reached: grippers are emptied, arms go home.
class CleanUp final : public ExecutionState {
 public:
  /// An arm that has failed so often stays where it is.
  explicit CleanUp(int max_attempts) : max_attempts_(max_attempts) {}

  std::string_view name() const override { return "clean_up"; }
  NextState Step(ExecutionContext& context, Instant now,
                 Decisions& out) override;
  void OnSkillEnd(const EndedSkill& ended) override;

 private:
  int max_attempts_;
  std::set<int> finished_;         // arms that are home, or cannot get there
  std::map<int, int> num_failed_;  // by arm
  std::string left_over_;          // why an arm is not home
};

}  // namespace cell::planner
