#pragma once

#include <functional>
#include <string>
#include <vector>

#include "services/planner/plan.h"
#include "services/planner/solver.h"
#include "services/planner/state_space.h"

namespace cell::planner {

struct Excuse {
  std::string text;
  std::vector<RequiredChange> needed;  ///< empty: nothing would help
};

/// Plain words for why the problem's goal cannot be reached from `state` of the
/// space: the goal's literals that no reachable state has together with the
/// others, and an excuse (section VI-B1): a smallest set of atoms that no
/// action changes and that, if flipped, would allow a plan, with the action
/// that needs them. Only if nothing else would help, what was done has to be
/// undone. A person is never asked to put something into a gripper.
/// @param space  of the problem
/// `solve` finds the plan for a state.
Excuse ExplainNoPlan(const Problem& problem, const StateSpace& space, int state,
                     const std::function<Plan(const State&)>& solve);

}  // namespace cell::planner
