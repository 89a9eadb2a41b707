#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/relational/rule.h"

namespace cell::planner {

struct PlanStep {
  GroundAction action;
  double probability = 0;       ///< of the outcome that the plan counts on
  double expected_actions = 0;  ///< to the goal when this is done first
  bool operator==(const PlanStep&) const = default;
};

/// An action that may change a state, and what follows when it is done first.
struct Alternative {
  PlanStep step;
  double probability = 0;  ///< of reaching the goal
};

/// A ground atom, and what it would have to be.
struct RequiredChange {
  int atom = 0;
  Truth truth = Truth::kTrue;
  std::string why = {};  ///< in plain words: which action needs it
  std::optional<GroundAction> needed_by = {};  ///< that action
  bool operator==(const RequiredChange&) const = default;
};

/// The best way to a goal: the highest probability of reaching it, then the
/// fewest actions to be expected.
struct Plan {
  enum class Result {
    kFound,
    kGoalReached,
    kNoPlan,
    kNotLearned,  ///< no rule brings about some of the goal
    kUndecided    ///< depends on atoms that are unknown, or is too large
  };
  Result result = Result::kUndecided;
  std::string reason;  ///< in plain words, if there is no plan
  std::vector<RequiredChange>
      needed;  ///< what would allow one, if something would
  /// kNotLearned: what no rule brings about.
  std::vector<Literal> unlearned = {};
  double probability = 0;
  double expected_actions = 0;  ///< given that the goal is reached
  std::vector<PlanStep> steps;  ///< the most likely course
  /// All actions from which the goal can be reached, best first.
  std::vector<PlanStep> next;
  bool operator==(const Plan&) const = default;

  /// True if the goal is reached, or can be.
  bool leads_to_goal() const {
    return result == Result::kFound || result == Result::kGoalReached;
  }
};

/// The plan for what was sensed at a key frame.
struct PlanOfState {
  int64_t key_frame = 0;
  int64_t utime = 0;  ///< [us]
  Plan plan;
};

}  // namespace cell::planner
