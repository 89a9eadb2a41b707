#pragma once

#include <cstdint>

#include "common/planning/ground_task.h"
#include "common/ppddl/problem.h"
#include "common/result/result.h"

namespace cell::planning {

struct GroundingLimits {
  int64_t max_actions = 2'000'000;
  /// Of one action: what independent probabilistic effects multiply to.
  int max_outcomes = 4096;
  /// Of one condition: what disjunctions multiply to.
  int max_alternatives = 4096;
};

/// The task of a PPDDL problem: actions for all objects that fit, without those
/// whose static conditions fail and those that can never apply; atoms that
/// never change are replaced by their truth. Costs and rewards are left out.
/// The reason names what is larger than the limits.
Result<GroundTask> GroundPpddl(const ppddl::Domain& domain,
                               const ppddl::Problem& problem,
                               const GroundingLimits& limits = {});

}  // namespace cell::planning
