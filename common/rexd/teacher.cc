#include "common/rexd/teacher.h"

#include <algorithm>

namespace cell::rexd {

using namespace rules;
namespace {

const Outcome* LikeliestOutcome(const Rule& rule) {
  const auto it =
      std::ranges::max_element(rule.outcomes, {}, &Outcome::probability);
  return it == rule.outcomes.end() ? nullptr : &*it;
}

/// True if some outcome of the rules leads from `before` to `after`.
bool Predicts(const NdrRules& known, const World& world, const GroundAct& act,
              const WorldState& before, const WorldState& after) {
  const auto coverage = FindCoverage(known, act, before, world);
  return coverage &&
         std::ranges::any_of(coverage->rule->outcomes, [&](const Outcome& o) {
           return Apply(o, coverage->binding, before, world) == after;
         });
}

}  // namespace

PlanningTeacher::PlanningTeacher(const RexdTask& task, double success,
                                 const Params& params, uint64_t seed)
    : task_(task),
      params_(params),
      robot_(WithSuccess(task.truth, success)),
      model_(std::make_shared<RuleModel>(
          task.truth, task, GroundActs(*task.world, task.initial))),
      planner_(model_, {}),
      random_(seed) {}

WorldState PlanningTeacher::Intended(const GroundAct& act,
                                     const WorldState& state) const {
  const auto coverage = FindCoverage(task_.truth, act, state, *task_.world);
  const Outcome* outcome =
      coverage ? LikeliestOutcome(*coverage->rule) : nullptr;
  return outcome ? Apply(*outcome, coverage->binding, state, *task_.world)
                 : state;
}

std::optional<double> PlanningTeacher::DistanceFrom(const WorldState& state) {
  const std::vector<uint64_t> words = model_->Pack(state);
  const auto it = distances_.find(words);
  if (it != distances_.end()) return it->second;
  const planning::Plan plan = planner_.Find(words);
  std::optional<double> distance;
  if (plan.status == planning::Plan::Status::kGoalReached) distance = 0;
  if (plan.status == planning::Plan::Status::kFound) {
    distance = plan.expected_actions;
  }
  return distances_[words] = distance;
}

std::vector<GroundAct> PlanningTeacher::UsefulActs(const WorldState& state) {
  std::vector<GroundAct> useful;
  const auto distance = DistanceFrom(state);
  if (!distance) return useful;
  for (const GroundAct& act : model_->acts()) {
    const WorldState after = Intended(act, state);
    if (after == state) continue;
    const auto next = DistanceFrom(after);
    if (next && *next < *distance - 1e-6) useful.push_back(act);
  }
  return useful;
}

bool PlanningTeacher::IsAskedFor(const GroundAct& act, const WorldState& state,
                                 const Guidance& guidance) const {
  const bool is_blocked = std::ranges::any_of(
      guidance.blocked_acts,
      [&](const auto& blocked) { return blocked.act == act; });
  if (is_blocked) return true;
  const WorldState after = Intended(act, state);
  return std::ranges::any_of(guidance.missing_effects,
                             [&](const Literal& effect) {
                               return !Holds(effect, {}, state, *task_.world) &&
                                      Holds(effect, {}, after, *task_.world);
                             });
}

std::optional<GroundAct> PlanningTeacher::Choose(const WorldState& state,
                                                 const Question& question) {
  std::vector<GroundAct> acts = UsefulActs(state);
  if (acts.empty()) return std::nullopt;
  const auto keep = [&](const auto& is_wanted) {
    std::vector<GroundAct> wanted;
    std::ranges::copy_if(acts, std::back_inserter(wanted), is_wanted);
    if (!wanted.empty()) acts = std::move(wanted);
  };
  if (params_.heeds_guidance && question.known != nullptr) {
    keep([&](const GroundAct& act) {
      return !Predicts(*question.known, *task_.world, act, state,
                       Intended(act, state));
    });
  }
  if (params_.heeds_guidance && question.guidance != nullptr) {
    keep([&](const GroundAct& act) {
      return IsAskedFor(act, state, *question.guidance);
    });
  }
  return acts[static_cast<size_t>(
      random_.Below(static_cast<int>(acts.size())))];
}

WorldState PlanningTeacher::Act(const GroundAct& act, const WorldState& state) {
  if (params_.is_sure) return Intended(act, state);
  return Simulate(robot_, *task_.world, act, state, &random_);
}

}  // namespace cell::rexd
