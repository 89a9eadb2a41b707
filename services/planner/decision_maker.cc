#include "services/planner/decision_maker.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/relational/ground_action.h"
#include "common/text/nearest.h"
#include "services/planner/execute.h"

namespace cell::planner {
namespace {

std::optional<Agent> FindAgent(const std::string& name) {
  if (name == "person") return Agent::kPerson;
  if (name == "robot") return Agent::kRobot;
  return std::nullopt;
}

Alert BadInput(std::string text, Instant now) {
  return {Alert::Cause::kBadInput, now.utime, std::move(text)};
}

}  // namespace

DecisionMaker::DecisionMaker(std::shared_ptr<const RuleSet> rules,
                             Params params)
    : rules_(std::move(rules)),
      params_(std::move(params)),
      state_(std::make_unique<Idle>()) {}

DecisionMaker::Answer DecisionMaker::ReplaceRules(
    std::shared_ptr<const RuleSet> rules) {
  if (const auto why = rules->WhyNotReplace(*rules_)) return Reason{*why};
  rules_ = std::move(rules);
  return state_->SetRules(rules_);
}

void DecisionMaker::SetExperiences(
    std::shared_ptr<const std::vector<TaskExperience>> experiences) {
  if (params_.execution.exploration) {
    params_.execution.exploration->experiences = experiences;
  }
  state_->SetExperiences(std::move(experiences));
}

void DecisionMaker::SetSecModels(std::shared_ptr<const SecModels> models) {
  params_.execution.sec_models = models;
  state_->SetSecModels(std::move(models));
}

DecisionMaker::Answer DecisionMaker::Confirm(const std::string& action) {
  if (!is_learning()) {
    return Reason{"this cell does not learn: there is nothing to confirm"};
  }
  if (!FindAction(rules_->actions(), action)) {
    return Reason{
        "there is no action '" + action + "'" +
        NamesInstead(action, NamesIn(rules_->actions(), &Action::name))};
  }
  params_.execution.exploration->confirmed.insert(action);
  state_->Confirm(action);
  return Decisions{};
}

Decisions DecisionMaker::OnEpisode(const Episode& episode, Instant now) {
  Decisions out = state_->Conclude(now);
  state_ = std::make_unique<Idle>();
  Decisions begun = Begin(episode, now);
  out.sense = begun.sense;
  out.alerts.insert(out.alerts.end(), begun.alerts.begin(), begun.alerts.end());
  return out;
}

Decisions DecisionMaker::Begin(const Episode& episode, Instant now) {
  const std::optional<Agent> agent = FindAgent(episode.agent);
  if (!agent) {
    return {.alerts = {BadInput(
                "The agent of an episode must be person or robot, not '" +
                    episode.agent + "'",
                now)}};
  }
  const Goal* goal = FindGoal(episode.goal);
  if (goal == nullptr) return {.alerts = {BadInput(NoGoal(episode.goal), now)}};
  if (agent == Agent::kRobot) {
    state_ = std::make_unique<Execute>(rules_, *goal, params_.make_solver,
                                       params_.execution, may_act_, now);
    return {};
  }
  state_ =
      std::make_unique<Watch>(rules_, params_.goals, *goal, params_.make_solver,
                              params_.watch, episode.has_joined_late);
  // There may be no further key frame.
  return {.sense = episode.has_joined_late};
}

void DecisionMaker::OnEpisodeEnd(Instant now) {
  if (!state_->OnEpisodeEnd(now)) state_ = std::make_unique<Idle>();
}

DecisionMaker::Answer DecisionMaker::SetGoal(const std::string& name) {
  const Goal* goal = FindGoal(name);
  if (goal == nullptr) return Reason{NoGoal(name)};
  if (!state_->HasGoal()) {
    return Reason{
        "no episode is running whose goal could be changed (cell episode "
        "start)"};
  }
  return state_->SetGoal(*goal);
}

void DecisionMaker::SetPermission(bool may_act, Instant now) {
  may_act_ = may_act;
  state_->SetPermission(may_act, now);
}

const Goal* DecisionMaker::FindGoal(const std::string& name) const {
  const auto it = std::ranges::find(params_.goals, name, &Goal::name);
  return it == params_.goals.end() ? nullptr : &*it;
}

std::string DecisionMaker::NoGoal(const std::string& name) const {
  return "The task has no goal '" + name + "'" +
         NamesInstead(name, NamesIn(params_.goals, &Goal::name));
}

}  // namespace cell::planner
