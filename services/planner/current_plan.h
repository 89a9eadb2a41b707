#pragma once

#include <memory>
#include <optional>
#include <set>

#include "services/planner/observations.h"
#include "services/planner/solver.h"

namespace cell::planner {

/// The robot's plan for a goal from the current state. It is recomputed only if
/// the state, the blocked actions, the goal or the rule set changes.
class CurrentPlan {
 public:
  CurrentPlan(std::shared_ptr<const RuleSet> rules, Goal goal,
              SolverMaker make_solver);

  const RuleSet& rules() const { return *rules_; }
  const std::shared_ptr<const RuleSet>& shared_rules() const { return rules_; }
  /// As if nothing had failed yet.
  Problem problem() const { return {rules_, goal_, Agent::kRobot}; }
  const std::set<GroundAction>& blocked() const { return blocked_; }
  const SolverMaker& make_solver() const { return make_solver_; }
  /// That the plan is for; nullopt if none was found yet.
  const std::optional<State>& state() const { return state_; }
  void SetGoal(Goal goal);
  void SetRules(std::shared_ptr<const RuleSet> rules);

  /// True if get() is what Find() would return.
  bool IsFor(const State& state, const std::set<GroundAction>& blocked) const;
  const Plan& Find(const State& state, const std::set<GroundAction>& blocked);
  /// The one last found, without steps before.
  const Plan& get() const { return plan_; }
  /// As if nothing had failed yet; not kept.
  Plan FindUnblocked(const State& state) const;
  /// A solver for that.
  std::unique_ptr<Solver> MakeUnblocked() const;
  /// A solver for the robot with other rules and another goal.
  std::unique_ptr<Solver> MakeSolverFor(
      std::shared_ptr<const RuleSet> rules, Goal goal,
      const std::set<GroundAction>& blocked) const;

  /// The plan, found for this, if it is another one than the last reported.
  std::optional<PlanOfState> TakeIfNew(const SensedState& sensed);

 private:
  void Forget();

  std::shared_ptr<const RuleSet> rules_;
  Goal goal_;
  SolverMaker make_solver_;
  std::set<GroundAction> blocked_;
  std::unique_ptr<Solver> solver_;  // of these; made when needed
  std::optional<State> state_;      // that the plan is for
  Plan plan_;
  std::optional<Plan> reported_;
};

}  // namespace cell::planner
