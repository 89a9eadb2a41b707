#pragma once

#include <optional>
#include <string>
#include <vector>

#include "services/planner/plan.h"

namespace cell::planner {

/// How far the robot is.
struct ExecutionStatus {
  enum class State { kRunning, kDone, kStuck };
  State state = State::kRunning;
  std::string action = {};  ///< being done; empty: none
  std::string text = {};    ///< kStuck: the question to the person
  /// kStuck: why it is asked, as conditions of the domain; empty: that is all.
  std::string formula = {};
  /// kStuck: what would have to be otherwise.
  std::vector<RequiredChange> needed = {};
  /// kStuck: of which the person is to show one.
  std::vector<Literal> unlearned = {};
  /// kStuck: the step that is left to a person.
  std::optional<GroundAction> step = {};
  bool operator==(const ExecutionStatus&) const = default;
};

}  // namespace cell::planner
