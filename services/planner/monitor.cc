#include "services/planner/monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "services/planner/question.h"

namespace cell::planner {
namespace {

bool IsDecided(const Plan& plan) {
  return plan.result != Plan::Result::kUndecided;
}

/// Of what nobody has shown, nothing can be said.
bool CanBeJudged(const Plan& plan) {
  return plan.result != Plan::Result::kNotLearned;
}

bool Concerns(const DoneAction& action, const GroundAtom& atom) {
  return std::any_of(atom.objects.begin(), atom.objects.end(), [&](int object) {
    return std::count(action.objects.begin(), action.objects.end(), object) > 0;
  });
}

}  // namespace

Monitor::Monitor(std::shared_ptr<const RuleSet> rules,
                 std::unique_ptr<Solver> solver, const Params& params)
    : rules_(std::move(rules)), solver_(std::move(solver)), params_(params) {}

Decisions Monitor::SetRules(std::shared_ptr<const RuleSet> rules,
                            std::unique_ptr<Solver> solver) {
  rules_ = std::move(rules);
  solver_ = std::move(solver);
  last_decided_.reset();
  if (states_.empty()) return {};
  return Report({}, false);
}

Decisions Monitor::Update(const SensedState& sensed) {
  if (!states_.emplace(sensed.key_frame, sensed).second) return {};
  std::vector<Alert> alerts = JudgeDeferred(sensed);
  bool has_acted = false;
  for (size_t i = 0; i < waiting_.size();) {
    if (waiting_[i].place_key_frame != sensed.key_frame) {
      ++i;
      continue;
    }
    const DoneAction action = waiting_[i];
    waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
    if (auto alert = Judge(action, sensed)) alerts.push_back(*alert);
    has_acted = true;
  }
  Forget();
  return Report(std::move(alerts), has_acted);
}

Decisions Monitor::Update(const DoneAction& action) {
  if (!actions_.emplace(action.index, action).second) return {};
  const auto after = states_.find(action.place_key_frame);
  if (after == states_.end()) {
    waiting_.push_back(action);
    Forget();
    return {};
  }
  std::vector<Alert> alerts;
  if (auto alert = Judge(action, after->second)) alerts.push_back(*alert);
  Forget();
  return Report(std::move(alerts), true);
}

/// What the person can do about it.
std::string Monitor::HelpFrom(const Plan& no_plan) const {
  const std::string words =
      WordsForChanges(no_plan, rules_->vocabulary(), params_.requests);
  return words.empty() ? ": " + no_plan.reason : "; please " + words;
}

std::optional<Alert> Monitor::Judge(const DoneAction& action,
                                    const SensedState& after) {
  const Plan plan = solver_->Find(after.state);
  if (!IsDecided(plan)) {
    deferred_.push_back(action);
    return std::nullopt;
  }
  if (!CanBeJudged(plan)) return std::nullopt;
  Judgement judgement = WithStates(action, after.state);
  const std::optional<double> without = judgement.expected_actions_before;
  const auto warn = [&](Alert::Cause cause, std::string text) {
    return Alert{cause, action.utime, std::move(text),
                 std::make_shared<const Judgement>(std::move(judgement))};
  };
  if (plan.result == Plan::Result::kNoPlan) {
    return warn(Alert::Cause::kNoPlan,
                fmt::format("After {} no plan leads to the goal{}", action.text,
                            HelpFrom(plan)));
  }
  const double now = plan.expected_actions;
  last_decided_ = now;
  if (!without || now <= *without + params_.min_detour) return std::nullopt;
  const std::string next =
      plan.steps.empty() ? ""
                         : "; best next: " + rules_->Show(plan.steps[0].action);
  return warn(Alert::Cause::kLongerPlan,
              fmt::format("{} has made the way to the goal longer: {:.1f} "
                          "instead of {:.1f} expected actions{}",
                          action.text, now, *without, next));
}

Judgement Monitor::WithStates(const DoneAction& action, const State& after) {
  Judgement judgement{action, after, StateWithout(action, after),
                      last_decided_};
  if (!judgement.before) return judgement;
  const Plan plan = solver_->Find(*judgement.before);
  if (plan.leads_to_goal()) {
    judgement.expected_actions_before = plan.expected_actions;
  }
  return judgement;
}

/// The state before the pick-up, but with what other actions have done since:
/// two hands may act at once, and while a part is in the air it is neither
/// here nor there.
std::optional<State> Monitor::StateWithout(const DoneAction& action,
                                           const State& after) const {
  auto before = states_.lower_bound(action.pick_key_frame);
  if (before == states_.begin()) return std::nullopt;
  --before;
  State state = before->second.state;
  for (int atom = 0; atom < state.num_atoms(); ++atom) {
    if (state.Get(atom) == after.Get(atom)) continue;
    const GroundAtom ground = rules_->vocabulary().Atom(atom);
    for (const auto& [index, other] : actions_) {
      if (index == action.index ||
          other.place_key_frame < action.pick_key_frame ||
          other.place_key_frame > action.place_key_frame ||
          !Concerns(other, ground) || Concerns(action, ground)) {
        continue;
      }
      state.Set(atom, after.Get(atom));
    }
  }
  return state;
}

std::vector<Alert> Monitor::JudgeDeferred(const SensedState& after) {
  std::vector<Alert> alerts;
  std::deque<DoneAction> deferred;
  deferred.swap(deferred_);
  for (const DoneAction& action : deferred) {
    if (action.place_key_frame > after.key_frame) {  // a late, older state
      deferred_.push_back(action);
      continue;
    }
    if (auto alert = Judge(action, after)) alerts.push_back(*alert);
  }
  return alerts;
}

void Monitor::Forget() {
  const auto max = static_cast<size_t>(params_.max_remembered);
  while (states_.size() > max) states_.erase(states_.begin());
  while (actions_.size() > max) actions_.erase(actions_.begin());
  while (waiting_.size() > max) waiting_.pop_front();
  while (deferred_.size() > max) deferred_.pop_front();
}

/// The plan of the latest state.
Decisions Monitor::Report(std::vector<Alert> alerts, bool has_acted) {
  const SensedState& latest = states_.rbegin()->second;
  PlanOfState plan{latest.key_frame, latest.utime, solver_->Find(latest.state)};
  if (!last_decided_ && plan.plan.leads_to_goal()) {
    last_decided_ = plan.plan.expected_actions;
  }
  Decisions out{.alerts = std::move(alerts)};
  if (!reported_ || has_acted || !out.alerts.empty() ||
      reported_->plan != plan.plan) {
    out.plan = plan;
    reported_ = std::move(plan);
  }
  return out;
}

}  // namespace cell::planner
