#include "services/planner/current_plan.h"

#include <utility>

namespace cell::planner {

CurrentPlan::CurrentPlan(std::shared_ptr<const RuleSet> rules, Goal goal,
                         SolverMaker make_solver)
    : rules_(std::move(rules)),
      goal_(std::move(goal)),
      make_solver_(std::move(make_solver)) {}

void CurrentPlan::SetGoal(Goal goal) {
  goal_ = std::move(goal);
  Forget();
}

void CurrentPlan::SetRules(std::shared_ptr<const RuleSet> rules) {
  rules_ = std::move(rules);
  Forget();
}

void CurrentPlan::Forget() {
  solver_.reset();
  state_.reset();
  plan_ = {};
}

bool CurrentPlan::IsFor(const State& state,
                        const std::set<GroundAction>& blocked) const {
  return solver_ != nullptr && blocked_ == blocked && state_ == state;
}

const Plan& CurrentPlan::Find(const State& state,
                              const std::set<GroundAction>& blocked) {
  if (IsFor(state, blocked)) return plan_;
  if (solver_ == nullptr || blocked_ != blocked) {
    blocked_ = blocked;
    solver_ = make_solver_({rules_, goal_, Agent::kRobot, blocked});
  }
  plan_ = solver_->Find(state);
  state_ = state;
  return plan_;
}

Plan CurrentPlan::FindUnblocked(const State& state) const {
  return MakeUnblocked()->Find(state);
}

std::unique_ptr<Solver> CurrentPlan::MakeUnblocked() const {
  return make_solver_(problem());
}

std::unique_ptr<Solver> CurrentPlan::MakeSolverFor(
    std::shared_ptr<const RuleSet> rules, Goal goal,
    const std::set<GroundAction>& blocked) const {
  return make_solver_(
      {std::move(rules), std::move(goal), Agent::kRobot, blocked});
}

std::optional<PlanOfState> CurrentPlan::TakeIfNew(const SensedState& sensed) {
  if (reported_ == plan_) return std::nullopt;
  reported_ = plan_;
  return PlanOfState{sensed.key_frame, sensed.utime, plan_};
}

}  // namespace cell::planner
