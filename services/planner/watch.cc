#include "services/planner/watch.h"

#include <utility>

namespace cell::planner {
namespace {

/// [us] What was done in an episode has been recognised so long after its end.
constexpr int64_t kLastActionUs = 500'000;

Decisions Warn(std::vector<std::string> texts, Instant now) {
  Decisions out;
  for (std::string& text : texts) {
    out.alerts.push_back(
        {Alert::Cause::kUnexplained, now.utime, std::move(text)});
  }
  return out;
}

}  // namespace

Watch::Watch(std::shared_ptr<const RuleSet> rules, std::span<const Goal> goals,
             const Goal& goal, SolverMaker make_solver, const Params& params,
             bool has_joined_late)
    : rules_(std::move(rules)),
      goal_(goal),
      make_solver_(std::move(make_solver)),
      params_(params),
      monitor_(rules_, MakeSolver(), params_.monitor),
      unexplained_(rules_->shared_vocabulary(), goals, params_.unexplained,
                   has_joined_late) {}

std::unique_ptr<Solver> Watch::MakeSolver() const {
  return make_solver_({rules_, goal_, Agent::kPerson});
}

std::optional<DecisionBasis> Watch::Basis() const {
  const SensedState* latest = monitor_.latest();
  if (latest == nullptr || !monitor_.reported()) return std::nullopt;
  return DecisionBasis{.problem = {rules_, goal_, Agent::kPerson},
                       .make_solver = make_solver_,
                       .state = latest->state,
                       .plan = monitor_.reported()->plan};
}

Decisions Watch::OnSensed(const SensedState& sensed) {
  SensedState by_person = sensed;
  by_person.state = WithoutArms(sensed.state, rules_->vocabulary());
  unexplained_.Update(by_person);
  return monitor_.Update(by_person);
}

Decisions Watch::OnAction(const DoneAction& action) {
  unexplained_.Update(action);
  return monitor_.Update(action);
}

Decisions Watch::SetRules(std::shared_ptr<const RuleSet> rules) {
  rules_ = std::move(rules);
  return monitor_.SetRules(rules_, MakeSolver());
}

Decisions Watch::SetGoal(const Goal& goal) {
  goal_ = goal;
  monitor_ = Monitor(rules_, MakeSolver(), params_.monitor);
  return {.sense = true};
}

Decisions Watch::Decide(Instant now) {
  if (!conclude_utime_ || now.utime < *conclude_utime_) return {};
  conclude_utime_.reset();
  return Conclude(now);
}

/// After a late start it asks until it receives the state: the estimator may be
/// dead at that time.
Decisions Watch::Review(Instant now) {
  Decisions out = Warn(unexplained_.TakeOverdue(now.utime), now);
  out.sense = unexplained_.has_joined_late() && !unexplained_.has_state();
  return out;
}

bool Watch::OnEpisodeEnd(Instant now) {
  is_over_ = true;
  conclude_utime_ = now.utime + kLastActionUs;
  return true;
}

Decisions Watch::Conclude(Instant now) {
  return Warn(unexplained_.TakeAll(), now);
}

}  // namespace cell::planner
