#include "services/planner/executor.h"

#include <algorithm>
#include <utility>

#include "services/planner/foresight.h"
#include "services/planner/question.h"

namespace cell::planner {
namespace {

ArmOrder::Kind KindOf(Skill::Kind kind) {
  switch (kind) {
    case Skill::Kind::kInsert:
      return ArmOrder::Kind::kInsert;
    case Skill::Kind::kPresent:
      return ArmOrder::Kind::kPresent;
    case Skill::Kind::kPutDown:
      return ArmOrder::Kind::kPutDown;
  }
  return ArmOrder::Kind::kPutDown;
}

}  // namespace

Executor::Executor(const Domain& domain, Goal goal, const Params& params,
                   int64_t since_utime)
    : domain_(domain),
      goal_(std::move(goal)),
      params_(params),
      arms_(domain.vocabulary()),
      attempts_(domain, params.max_attempts),
      since_utime_(since_utime),
      fresh_utime_(since_utime) {}

void Executor::Take(const SensedState& sensed) {
  if (!sensed_ || sensed.utime >= sensed_->utime) sensed_ = sensed;
}

void Executor::Take(const ArmOutcome& result) {
  const auto it = running_.find(result.arm);
  if (it == running_.end() || it->second.id != result.id) return;
  const bool was_to_go_free = it->second.kind == ArmOrder::Kind::kGoFree;
  const bool has_succeeded = result.outcome == ArmOutcome::Outcome::kSucceeded;
  const bool is_stopped = result.outcome == ArmOutcome::Outcome::kStopped;
  const bool counts =
      !is_stopped && result.outcome != ArmOutcome::Outcome::kYielded;
  if (is_stopped) to_free_.try_emplace(result.arm, 0);
  if (it->second.action) {
    End(result.arm, result.utime, counts,
        has_succeeded ? "it was reported as done, but is not" : result.reason);
    return;
  }
  const bool is_home = it->second.kind == ArmOrder::Kind::kGoHome;
  End(result.arm, result.utime, false, "");
  if (was_to_go_free) {
    if (counts) OnFreed(result.arm, has_succeeded);
    return;
  }
  if (has_succeeded && is_home) home_.insert(result.arm);
  if (has_succeeded || !counts) return;
  if (++num_clearings_[result.arm] < params_.max_attempts) return;
  home_.insert(result.arm);
  left_over_ = result.reason;
}

void Executor::Take(const DoneAction& action) {
  if (!stuck_utime_ || action.pick_utime < *stuck_utime_) return;
  // The person has let go: what is there now is to be looked at.
  asked_for_.reset();
  fresh_utime_ = std::max(fresh_utime_, action.utime + params_.settle_us);
  for (const int object : action.objects) attempts_.ForgetAbout(object);
}

void Executor::Pursue(Goal goal) {
  goal_ = std::move(goal);
  search_.reset();
  plan_ = {};
  attempts_.Clear();
  stage_ = Stage::kWorking;
  undecided_utime_.reset();
  stuck_utime_.reset();
  asked_for_.reset();
}

Orders Executor::Decide(Instant now) {
  Orders orders;
  num_requests_ = 0;
  FindLostRequests();
  if (may_act_ && !has_acted_) fresh_utime_ = std::max(fresh_utime_, now.utime);
  has_acted_ = may_act_;
  if (may_act_ && IsReady(now) && AreFree(now, orders)) {
    if (stage_ == Stage::kWorking) Work(now, orders);
    if (stage_ == Stage::kClearingUp) ClearUp(now, orders);
  }
  if (!stuck_utime_ && stage_ != Stage::kDone) {
    Tell({Execution::State::kRunning, WhatRuns(), "", {}}, orders);
  }
  return orders;
}

/// A life begins when all arms have come to rest: what an earlier one has asked
/// for may still be under way.
bool Executor::IsReady(Instant now) {
  if (!arms_.HaveReportedSince(since_utime_)) return false;
  if (is_ready_) return true;
  if (!arms_.AreIdle()) return false;
  is_ready_ = true;
  fresh_utime_ = std::max(fresh_utime_, now.utime);
  return true;
}

/// An arm that cannot go free is used as it is after some attempts: it refuses
/// what it cannot do.
void Executor::OnFreed(int arm, bool has_succeeded) {
  const auto it = to_free_.find(arm);
  if (it == to_free_.end()) return;
  if (has_succeeded || ++it->second >= params_.max_attempts) to_free_.erase(it);
}

bool Executor::AreFree(Instant now, Orders& orders) {
  for (const auto& [arm, tries] : to_free_) {
    if (now.utime < fresh_utime_ || !IsFree(arm)) continue;
    Start({0, 0, arm, ArmOrder::Kind::kGoFree, std::nullopt, std::nullopt},
          {.action = std::nullopt, .before = State(0)}, now, orders);
  }
  return to_free_.empty();
}

void Executor::Work(Instant now, Orders& orders) {
  const auto& arms = arms_.arms();
  if (std::none_of(arms.begin(), arms.end(),
                   [this](int arm) { return IsFree(arm); })) {
    return;
  }
  if (!sensed_ || sensed_->utime < fresh_utime_) {
    if (now.utime >= fresh_utime_) Sense(now, params_.sense_period_us, orders);
    return;
  }
  const State state = arms_.WithReports(sensed_->state);
  // While something is under way the state may look odd: no new plan for it.
  if (!running_.empty()) return PassOn(state, now, orders);
  if (IsPersonAtIt(state, now)) {
    return Sense(now, params_.watch_period_us, orders);
  }
  attempts_.Update(state);
  const Plan& plan = FindPlan(state);
  if (!told_plan_ || told_plan_->plan != plan) {
    orders.plan = told_plan_ =
        Monitor::PlanOfState{sensed_->key_frame, sensed_->utime, plan};
  }
  if (plan.result == Plan::Result::kFound) return Act(plan, state, now, orders);
  if (plan.result == Plan::Result::kGoalReached) {
    stage_ = Stage::kClearingUp;
    home_.clear();
    num_clearings_.clear();
    left_over_.clear();
    stuck_utime_.reset();
    return;
  }
  WaitOrAsk(plan, state, now, orders);
}

const Plan& Executor::FindPlan(const State& state) {
  std::set<GroundAction> blocked = attempts_.Blocked();
  if (!search_ || search_->params().blocked != blocked) {
    PlanSearch::Params params = params_.search;
    params.blocked = std::move(blocked);
    search_.emplace(domain_, goal_, params);
    planned_for_.reset();
  }
  if (planned_for_ != state) {
    plan_ = search_->Find(state);
    planned_for_ = state;
    question_.reset();
  }
  return plan_;
}

void Executor::Act(const Plan& plan, const State& state, Instant now,
                   Orders& orders) {
  const GroundAction& action = plan.steps.at(0).action;
  if (IsForPerson(action)) {
    return AskPerson(
        {Execution::State::kStuck, "", AskForStep(action, domain_), {}, action},
        state, now, orders);
  }
  if (!IsSurelyPossible(domain_, action, state)) {
    return WaitOrAsk(plan, state, now, orders);
  }
  if (!IsFree(domain_.SkillOf(action)->arm)) return;
  Request(action, state, now, orders);
  PassOn(state, now, orders);
}

/// Lets another arm do what the plan wants passed on later.
void Executor::PassOn(const State& state, Instant now, Orders& orders) {
  if (!params_.parallel) return;
  for (const PlanStep& step : plan_.steps) {
    if (!MayRunBeside(step.action, state)) continue;
    Request(step.action, state, now, orders);
  }
}

/// Asks the person if there is no way, or none that is sure; for a while it may
/// clear up, as when a person is at work.
void Executor::WaitOrAsk(const Plan& plan, const State& state, Instant now,
                         Orders& orders) {
  const auto ask = [&](const std::string& text, std::vector<Wish> needed) {
    AskPerson({Execution::State::kStuck, "", text, std::move(needed)}, state,
              now, orders);
  };
  if (!undecided_utime_) undecided_utime_ = now.utime;
  if (now.utime - *undecided_utime_ < params_.patience_us) {
    return Sense(now, params_.sense_period_us, orders);
  }
  if (plan.result == Plan::Result::kNoPlan) {
    if (!question_) {
      question_ = AskForHelp(
          plan, state, PlanSearch(domain_, goal_, params_.search), attempts_);
    }
    return ask(*question_, plan.needed);
  }
  const bool is_found = plan.result == Plan::Result::kFound;
  ask(is_found ? "it cannot be seen whether " +
                     domain_.Show(plan.steps[0].action) + " is possible"
               : plan.reason,
      {});
}

void Executor::AskPerson(Execution question, const State& state, Instant now,
                         Orders& orders) {
  if (!stuck_utime_) stuck_utime_ = now.utime;
  if (!asked_for_) asked_for_ = Asked{state, state, now.utime};
  Tell(std::move(question), orders);
  Sense(now, params_.watch_period_us, orders);
}

/// While a person is at what was asked for the state may look odd: it is
/// looked at when the person has let go, or when it has stayed as it is.
bool Executor::IsPersonAtIt(const State& state, Instant now) {
  if (!asked_for_ || state == asked_for_->state) return false;
  if (state != asked_for_->latest) {
    asked_for_->latest = state;
    asked_for_->since_utime = now.utime;
  }
  if (now.utime - asked_for_->since_utime < params_.patience_us) return true;
  asked_for_.reset();
  return false;
}

void Executor::Sense(Instant now, int64_t period_us, Orders& orders) {
  if (asked_utime_ && now.utime - *asked_utime_ < period_us) return;
  asked_utime_ = now.utime;
  orders.sense = true;
}

bool Executor::IsFree(int arm) const {
  const ArmStatus* report = arms_.Of(arm);
  return !running_.contains(arm) && report != nullptr &&
         report->request == ArmStatus::kIdle;
}

bool Executor::IsForPerson(const GroundAction& action) const {
  return params_.help_steps.contains(action) || !domain_.SkillOf(action);
}

/// If it neither concerns what the other arms work at nor keeps them from it.
bool Executor::MayRunBeside(const GroundAction& action,
                            const State& state) const {
  const auto skill = domain_.SkillOf(action);
  if (IsForPerson(action) || skill->kind != Skill::Kind::kPresent ||
      !IsFree(skill->arm) || attempts_.Blocked().contains(action) ||
      !IsSurelyPossible(domain_, action, state)) {
    return false;
  }
  return std::all_of(running_.begin(), running_.end(), [&](const auto& entry) {
    const Running& other = entry.second;
    return other.action && other.part != skill->part &&
           DoNotDisturb(domain_, action, *other.action, other.before);
  });
}

void Executor::Request(const GroundAction& action, const State& state,
                       Instant now, Orders& orders) {
  const GroundSkill skill = *domain_.SkillOf(action);
  ArmOrder request{0, 0, skill.arm, KindOf(skill.kind), skill.part, skill.site};
  Start(std::move(request), {.action = action, .before = state}, now, orders);
}

void Executor::Start(ArmOrder request, Running running, Instant now,
                     Orders& orders) {
  constexpr int kMaxPerTick = 256;
  request.id = int64_t{now.tick} * kMaxPerTick + num_requests_++;
  request.deadline_utime = now.utime + params_.deadline_us;
  running.id = request.id;
  running.kind = request.kind;
  running.part = request.part;
  running.asked_utime = now.utime;
  running_.insert_or_assign(request.arm, std::move(running));
  orders.requests.push_back(std::move(request));
  stuck_utime_.reset();
  undecided_utime_.reset();
}

/// An arm that has been idle for too long after it was asked has begun a new
/// life and knows nothing of it.
void Executor::FindLostRequests() {
  std::vector<std::pair<int, int64_t>> lost;
  for (auto& [arm, running] : running_) {
    const ArmStatus* report = arms_.Of(arm);
    if (report == nullptr || report->utime < running.asked_utime) continue;
    if (report->request == running.id) {
      running.asked_utime = report->utime;
    } else if (report->utime - running.asked_utime >= params_.lost_us) {
      lost.emplace_back(arm, report->utime);
    }
  }
  for (const auto& [arm, utime] : lost) {
    if (running_.at(arm).kind == ArmOrder::Kind::kGoFree) {
      OnFreed(arm, false);
    } else {
      to_free_.try_emplace(arm, 0);
    }
    End(arm, utime, true, "the arm began anew and knows nothing of it");
  }
}

void Executor::End(int arm, int64_t utime, bool counts,
                   const std::string& reason) {
  const Running ended = std::move(running_.at(arm));
  running_.erase(arm);
  if (counts && ended.action)
    attempts_.Add(*ended.action, ended.before, reason);
  since_utime_ = std::max(since_utime_, utime);
  fresh_utime_ = std::max(fresh_utime_, utime + params_.settle_us);
}

/// The goal is reached: grippers are emptied, arms go home.
void Executor::ClearUp(Instant now, Orders& orders) {
  bool is_clear = true;
  for (const int arm : arms_.arms()) {
    if (home_.contains(arm)) continue;
    is_clear = false;
    if (!IsFree(arm)) continue;
    const std::optional<int> held = arms_.Of(arm)->held;
    const auto kind = held ? ArmOrder::Kind::kPutDown : ArmOrder::Kind::kGoHome;
    Start({0, 0, arm, kind, held, std::nullopt},
          {.action = std::nullopt, .before = State(0)}, now, orders);
  }
  if (!is_clear) return;
  stage_ = Stage::kDone;
  Tell({Execution::State::kDone, "", left_over_, {}}, orders);
}

void Executor::Tell(Execution execution, Orders& orders) {
  if (told_ == execution) return;
  told_ = execution;
  orders.execution = std::move(execution);
}

std::string Executor::WhatRuns() const {
  std::string text;
  for (const auto& [arm, running] : running_) {
    if (!text.empty()) text += ", ";
    const bool goes_free = running.kind == ArmOrder::Kind::kGoFree;
    text += running.action ? domain_.Show(*running.action)
                           : domain_.vocabulary().objects()[arm].name +
                                 (goes_free ? " arm goes free of what it is at"
                                            : " arm goes home");
  }
  return text;
}

}  // namespace cell::planner
