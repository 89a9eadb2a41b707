#pragma once

#include <optional>

#include "common/relational/domain.h"

namespace cell::planner {

/// The state after the likeliest outcome of the robot's action; nothing if no
/// rule covers `state`, or several do.
std::optional<State> LikelyAfter(const Domain& domain,
                                 const GroundAction& action,
                                 const State& state);

/// True if the robot's action is possible in `state` whatever its unknown
/// atoms are.
bool IsSurelyPossible(const Domain& domain, const GroundAction& action,
                      const State& state);

/// True if both actions are possible in `state`, and each after the other.
bool DoNotDisturb(const Domain& domain, const GroundAction& a,
                  const GroundAction& b, const State& state);

}  // namespace cell::planner
