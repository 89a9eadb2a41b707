#include "common/rexd/rexd.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "common/rexd/rule_alternatives.h"

namespace cell::rexd {

using namespace rules;

RexD::RexD(const RexdTask& task, const Params& params)
    : task_(&task),
      params_(params),
      learner_(task.world, params.learner),
      rules_{task.world->shared_symbols(), {}},
      random_(params.seed),
      dangers_(task) {}

void RexD::SetTask(const RexdTask& task) {
  if (task.world != task_->world) {
    throw std::invalid_argument("the next task is of another world");
  }
  task_ = &task;
  dangers_.SetTask(task);
  last_.reset();
  shown_in_vain_.reset();
  failures_ = {};
  num_alternatives_ = 0;
}

std::vector<GroundAct> RexD::KnownActs() const {
  std::vector<GroundAct> acts;
  for (GroundAct& act : GroundActs(*task_->world, task_->initial)) {
    if (actions_.contains(act.action)) acts.push_back(std::move(act));
  }
  return acts;
}

double RexD::ChangeProbability(const GroundAct& act,
                               const WorldState& state) const {
  const auto coverage = FindCoverage(rules_, act, state, *task_->world);
  if (!coverage) return 0;
  double p = coverage->rule->noise;
  for (const Outcome& outcome : coverage->rule->outcomes) {
    if (Apply(outcome, coverage->binding, state, *task_->world) != state) {
      p += outcome.probability;
    }
  }
  const double count =
      counts_[static_cast<size_t>(coverage->rule - rules_.rules.data())];
  return (count * p + 1) / (count + 2);
}

bool RexD::IsNoOp(const GroundAct& act, const WorldState& state) const {
  const auto coverage = FindCoverage(rules_, act, state, *task_->world);
  if (!coverage || coverage->rule->noise > 0) return false;
  return std::ranges::all_of(
      coverage->rule->outcomes, [&](const Outcome& outcome) {
        return Apply(outcome, coverage->binding, state, *task_->world) == state;
      });
}

std::optional<GroundAct> RexD::LeastTried(const WorldState& state) {
  std::vector<GroundAct> least;
  int least_count = params_.known_count;
  for (const GroundAct& act : KnownActs()) {
    const auto coverage = FindCoverage(rules_, act, state, *task_->world);
    if (!coverage || dangers_.IsDangerous(act, state)) continue;
    const int count =
        counts_[static_cast<size_t>(coverage->rule - rules_.rules.data())];
    if (count > least_count || count >= params_.known_count) continue;
    if (!params_.explores_no_ops && IsNoOp(act, state)) continue;
    if (count < least_count) least.clear();
    least_count = count;
    least.push_back(act);
  }
  if (least.empty()) return std::nullopt;
  return least[static_cast<size_t>(
      random_.Below(static_cast<int>(least.size())))];
}

planning::Planner::Params RexD::PlannerParams() const {
  planning::Planner::Params params;
  params.max_expansions = params_.max_expansions;
  params.precision = 1e-3;
  return params;
}

std::optional<GroundAct> RexD::PlanBy(const NdrRules& rules,
                                      const RexdTask& task,
                                      const WorldState& state) const {
  RuleModel::IsForbidden is_forbidden;
  if (!dangers_.dead_ends().empty()) {
    is_forbidden = [&](const GroundAct& act, const WorldState& s) {
      return dangers_.IsDangerous(act, s);
    };
  }
  const auto model =
      std::make_shared<RuleModel>(rules, task, KnownActs(), is_forbidden);
  planning::Planner planner(model, PlannerParams());
  const planning::Plan plan = planner.Find(model->Pack(state));
  if (plan.status != planning::Plan::Status::kFound || plan.course.empty()) {
    return std::nullopt;
  }
  return model->acts()[static_cast<size_t>(plan.course[0].action)];
}

std::optional<GroundAct> RexD::Plan(const WorldState& state) {
  return PlanBy(rules_, *task_, state);
}

std::shared_ptr<RuleModel> RexD::Model() const {
  return std::make_shared<RuleModel>(rules_, *task_, KnownActs());
}

std::optional<GroundAct> RexD::DoWithoutPlan(const WorldState& state,
                                             const Guidance& guidance) {
  constexpr size_t kMaxPlans = 30;
  if (num_alternatives_ < params_.max_alternatives) {
    const auto alternatives =
        RuleAlternatives(rules_, *task_->world, state, guidance, experiences_);
    for (size_t i = 0; i < std::min(alternatives.size(), kMaxPlans); ++i) {
      const auto act = PlanBy(alternatives[i], *task_, state);
      if (!act || HasFailedTooOften(*act, state)) continue;
      ++num_alternatives_;
      return act;
    }
  }
  if (!params_.uses_subgoals || guidance.subgoals.empty()) return std::nullopt;
  RexdTask meanwhile = *task_;
  meanwhile.goal = guidance.subgoals;
  const auto act = PlanBy(rules_, meanwhile, state);
  if (act && HasFailedTooOften(*act, state)) return std::nullopt;
  return act;
}

bool RexD::HasFailedTooOften(const GroundAct& act,
                             const WorldState& state) const {
  return last_ && last_->act == act && last_->after == state &&
         failures_.number > 0 &&
         std::pow(1 - failures_.p_at_first, failures_.number) <
             params_.least_failure_probability;
}

Decision RexD::Decide(const WorldState& state) {
  if (dangers_.dead_ends().LooksDead(state))
    return {Decision::Kind::kAsk, {}, {}};
  if (shown_in_vain_ && last_ && last_->after == state &&
      num_repetitions_ < params_.max_repetitions &&
      !dangers_.IsDangerous(*shown_in_vain_, state)) {
    ++num_repetitions_;
    return {Decision::Kind::kExplore, *shown_in_vain_, {}};
  }
  if (const auto act = LeastTried(state)) {
    return {Decision::Kind::kExplore, *act, {}};
  }
  const auto act = Plan(state);
  const bool is_stuck = act && HasFailedTooOften(*act, state);
  if (act && !is_stuck) return {Decision::Kind::kExploit, *act, {}};
  if (is_stuck) return {Decision::Kind::kAsk, {}, {}};
  const Guidance guidance = FindGuidance(rules_, *task_, state, KnownActs());
  if (const auto other = DoWithoutPlan(state, guidance)) {
    return {Decision::Kind::kExploit, *other, {}};
  }
  return {Decision::Kind::kAsk, {}, guidance};
}

void RexD::Observe(const Experience& experience, bool is_demonstrated) {
  if (is_demonstrated) {
    num_repetitions_ = 0;
    num_alternatives_ = 0;
    shown_in_vain_ = experience.act;
  }
  if (experience.before != experience.after) {
    shown_in_vain_.reset();
    num_alternatives_ = 0;
  }
  const bool is_repeated = last_ && failures_.number > 0 &&
                           last_->act == experience.act &&
                           last_->before == experience.before;
  if (!is_repeated) {
    failures_.number = 0;
    failures_.p_at_first = ChangeProbability(experience.act, experience.before);
  }
  if (experience.before == experience.after) ++failures_.number;
  dangers_.Observe(experience, is_demonstrated);
  last_ = experience;
  actions_.insert(experience.act.action);
  experiences_.push_back(experience);
  if (!is_demonstrated) robot_experiences_.push_back(experience);
  learner_.Add(experience);
  learner_.Learn();
  rules_ = learner_.Rules();
  counts_ = learner_.RuleCounts();
}

AgentRules RexD::RobotRules() const {
  return WithRatesOf(robot_experiences_, rules_, *task_->world);
}

void RexD::RememberDeadEnd() {
  dangers_.RememberDeadEnd();
  last_.reset();
}

}  // namespace cell::rexd
