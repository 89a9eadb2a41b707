#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/relational/bound_condition.h"
#include "services/planner/excuse.h"
#include "services/planner/solver.h"
#include "services/planner/state_space.h"
#include "services/planner/value_iteration.h"

namespace cell::planner {

/// Value iteration over all states that can be reached.
class PlanSearch final : public Solver {
 public:
  struct Params {
    /// More reachable states than these: undecided. 100 bytes to 1 kB each.
    int max_states = 100'000;
  };

  PlanSearch(Problem problem, const Params& params);
  static SolverMaker Maker(const Params& params);

  Plan Find(const State& state) override;
  Plan FindWithoutReason(const State& state) override;
  std::vector<Alternative> Alternatives(const State& state) override;
  int num_states() const { return space_.size(); }

 private:
  /// The plan for a state, without a reason if there is none.
  Plan Solve(const State& state);
  /// Nothing if there are too many states.
  std::optional<int> Enter(const State& state);
  std::vector<PlanStep> LikelyCourse(int state) const;
  /// Best first.
  std::vector<Alternative> Ranked(int state) const;
  std::vector<PlanStep> NextSteps(int state) const;
  Excuse WhyNoPlan(const State& state);
  std::string WhyUndecided(const State& state) const;

  const Vocabulary& vocabulary() const { return problem_.rules->vocabulary(); }

  Problem problem_;
  Params params_;
  BoundCondition goal_;
  StateSpace space_;
  ValueIteration values_;
  std::vector<bool> is_goal_;  // of each state of the space
};

}  // namespace cell::planner
