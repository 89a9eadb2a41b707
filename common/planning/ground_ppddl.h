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

enum class ConstantAtoms {
  kReplace,  ///< by their truth, and leave out what can never apply
  kKeep      ///< for FindExcuses(), which asks what if they were otherwise
};

/// The task of a PPDDL problem: the actions for all objects that fit. Costs and
/// rewards are left out. The reason names what is larger than the limits.
Result<GroundTask> GroundPpddl(
    const ppddl::Domain& domain, const ppddl::Problem& problem,
    ConstantAtoms constants = ConstantAtoms::kReplace,
    const GroundingLimits& limits = {});

}  // namespace cell::planning
