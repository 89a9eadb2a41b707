#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "services/planner/excuse.h"
#include "services/planner/goal_values.h"
#include "services/planner/plan.h"
#include "services/planner/state_space.h"

namespace cell::planner {

/// Finds the best way to one goal from any state (section VIII-A). What was
/// found out about states is kept for later questions.
class PlanSearch {
 public:
  struct Params {
    Agent agent = Agent::kPerson;    ///< who acts
    std::set<GroundAction> blocked;  ///< not to be counted on
    /// More reachable states than these: undecided. 100 bytes to 1 kB each.
    int max_states = 100'000;
  };

  /// `domain` must outlive this object.
  PlanSearch(const Domain& domain, Goal goal, const Params& params);

  /// Unknown atoms are taken as false; if there is no plan then but might be
  /// one were they otherwise, the result is undecided.
  Plan Find(const State& state);

  const Domain& domain() const { return space_.domain(); }
  const Params& params() const { return params_; }
  int num_states() const { return space_.size(); }

 private:
  /// The plan for a state, without a reason if there is none.
  Plan Solve(const State& state);
  /// Nothing if there are too many states.
  std::optional<int> Enter(const State& state);
  bool IsReached(const State& state) const;
  std::vector<PlanStep> LikelyCourse(int state) const;
  std::vector<PlanStep> NextSteps(int state) const;
  Excuse WhyNoPlan(const State& state);
  std::string WhyUndecided(const State& state) const;

  Goal goal_;
  Params params_;
  StateSpace space_;
  GoalValues values_;
  std::vector<bool> is_goal_;  // of each state of the space
};

}  // namespace cell::planner
