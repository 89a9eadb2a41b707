#pragma once

#include <vector>

#include "common/relational/rule_set.h"
#include "services/planner/solver.h"

namespace cell::planner {

/// Literals of the problem's goal that do not hold in `state` and that no rule
/// of its agent brings about: nobody has shown yet how to do that. In the
/// goal's order.
std::vector<Literal> UnlearnedLiterals(const Problem& problem,
                                       const State& state);

/// What can be done of a goal while some of it is not learned (section VI-B1):
/// without the `unlearned` literals, and without those that only rules bring
/// about which need one of the left out literals.
Goal Subgoals(const Problem& problem, const State& state,
              const std::vector<Literal>& unlearned);

}  // namespace cell::planner
