#pragma once

#include <cstdint>

#include "common/planning/planner.h"

namespace cell::planning {

struct Rollouts {
  int num_runs = 0;
  int num_reached = 0;      ///< runs that ended in a goal
  double mean_actions = 0;  ///< of those
  bool operator==(const Rollouts&) const = default;
};

/// Executes the plan that `planner` found last, which must have begun in
/// `start`, with outcomes drawn from the model. A run ends in a goal, where the
/// plan does nothing, or after `max_actions`.
Rollouts RollOut(const Model& model, const Planner& planner, Bits start,
                 int num_runs, uint64_t seed, int max_actions = 100'000);

}  // namespace cell::planning
