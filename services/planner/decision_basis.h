#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>

#include "services/planner/decisions.h"
#include "services/planner/exploration.h"
#include "services/planner/failure_history.h"
#include "services/planner/skill_dispatch.h"
#include "services/planner/solver.h"

namespace cell::planner {

/// What the decision maker decides by at a moment, for those who explain its
/// decisions.
struct DecisionBasis {
  Problem problem;
  SolverMaker make_solver;
  State state = State(0);  ///< that the plan is for
  Plan plan;
  std::map<GroundAction, FailureHistory::Entry> failures = {};
  std::map<int, RunningSkill> running = {};     ///< by arm
  std::optional<Exploration> exploration = {};  ///< if the cell learns
  std::set<GroundAction> not_to_begin = {};
};

/// Sees all decisions when they are published, except empty ones. No basis if
/// nothing was planned.
using DecisionObserver = std::function<void(
    Instant, const Decisions&, const std::optional<DecisionBasis>&)>;

}  // namespace cell::planner
