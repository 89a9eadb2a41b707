#pragma once

#include <optional>

#include "services/planner/observations.h"

namespace cell::planner {

/// A person's action, and the states that it is judged by.
struct Judgement {
  DoneAction action;
  State after;
  /// As if it had not been made; nullopt if that is not known.
  std::optional<State> before;
  /// To the goal from there; nullopt if no plan is known from there.
  std::optional<double> expected_actions_before;
};

}  // namespace cell::planner
