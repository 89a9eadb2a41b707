#include "services/planner/planner.h"

#include <cctype>
#include <utility>

#include "cell/library_request_t.hpp"
#include "cell/sense_request_t.hpp"
#include "common/actions/action_model_reader.h"
#include "common/actions/record_messages.h"
#include "common/task/task.h"
#include "services/planner/execution_messages.h"
#include "services/planner/planner_config.h"
#include "services/planner/planner_messages.h"

namespace cell::planner {
namespace {

constexpr int32_t kReviewPeriod = 125;  // [ticks]

std::string InCapitals(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return text;
}

}  // namespace

Planner::Planner(Bus& bus, Domain domain,
                 std::unique_ptr<DecisionMaker> decision_maker)
    : bus_(bus),
      domain_(std::move(domain)),
      decision_maker_(std::move(decision_maker)) {
  bus_.Subscribe<episode_t>("EPISODE",
                            [this](const auto& m) { return OnEpisode(m); });
  AnswerCommands<command_goal_t>(bus_, "COMMAND_GOAL",
                                 [this](const auto& m) { return OnGoal(m); });
  bus_.Subscribe<operating_mode_t>("MODE",
                                   [this](const auto& m) { return OnMode(m); });
  bus_.Subscribe<predicates_t>(
      "PREDICATES", [this](const auto& m) { return OnPredicates(m); });
  bus_.Subscribe<recognised_action_t>(
      "ACTION", [this](const auto& m) { return OnAction(m); });
  bus_.Subscribe<action_record_t>(
      "ACTION_RECORD", [this](const auto& m) { return OnRecord(m); });
  bus_.Subscribe<skill_result_t>("SKILL_RESULT",
                                 [this](const auto& m) { return OnResult(m); });
  const RuleSet& rules = decision_maker_->rules();
  const ArmStates arms(rules.shared_vocabulary());
  for (const int arm : arms.arms()) {
    const std::string& name = rules.vocabulary().objects()[arm].name;
    bus_.Subscribe<arm_report_t>(
        "ARM_REPORT_" + InCapitals(name),
        [this, name](const auto& m) { return OnReport(name, m); });
  }
  // After all messages.
  bus_.Every(1, 0, [this] { Publish(decision_maker_->state().Decide(Now())); });
  bus_.Every(kReviewPeriod, 0,
             [this] { Publish(decision_maker_->state().Review(Now())); });
}

bool Planner::OnEpisode(const episode_t& message) {
  const auto event = episode_.Update(message);
  const bool has_joined_late = event == EpisodeEvent::kJoins;
  if (has_joined_late) {
    bus_.Publish("LIBRARY_REQUEST",
                 library_request_t{{bus_.now(), 0, 0, 0}, 0});
  }
  if (event == EpisodeEvent::kEnds) decision_maker_->OnEpisodeEnd(Now());
  if (event == EpisodeEvent::kBegins || has_joined_late) {
    Publish(decision_maker_->OnEpisode(
        {has_joined_late, message.agent, message.goal}, Now()));
  }
  return event.has_value();
}

CommandAnswer Planner::OnGoal(const command_goal_t& message) {
  const DecisionMaker::Answer answer = decision_maker_->SetGoal(message.goal);
  if (!answer) return CommandAnswer::Refuse(answer.reason());
  Publish(*answer);
  return CommandAnswer::Accept("the episode's goal is now " + message.goal);
}

bool Planner::OnMode(const operating_mode_t& message) {
  const std::optional<bool> may_act = MayActFromMessage(message);
  if (may_act) decision_maker_->SetPermission(*may_act, Now());
  return may_act.has_value();
}

bool Planner::OnPredicates(const predicates_t& message) {
  if (episode_.IsBefore(message.header.utime)) return true;
  if (message.header.utime > bus_.now()) return false;
  const auto sensed =
      FromMessage(message, decision_maker_->rules().vocabulary());
  if (sensed) Publish(decision_maker_->state().OnSensed(*sensed));
  return sensed.has_value();
}

bool Planner::OnAction(const recognised_action_t& message) {
  if (episode_.IsBefore(message.header.utime)) return true;
  const auto action = FromMessage(message, decision_maker_->rules());
  if (action) Publish(decision_maker_->state().OnAction(*action));
  return action.has_value();
}

bool Planner::OnRecord(const action_record_t& message) {
  const auto refuse = [this](const std::string& why) {
    const Alert alert{Alert::Cause::kBadInput, bus_.now(),
                      "ACTION_RECORD " + why};
    bus_.Publish("ALERT", ToMessage(alert));
    return false;
  };
  try {
    const ActionRecord record = cell::FromMessage(message);
    if (!domain_.Put(ReadAction(record, domain_))) return true;
    const int64_t version = decision_maker_->rules().version() + 1;
    const DecisionMaker::Answer answer = decision_maker_->ReplaceRules(
        RuleSet::FromDomain(domain_, record.name, version));
    if (!answer) return refuse(answer.reason());
    Publish(*answer);
    return true;
  } catch (const ConfigError& e) {
    return refuse(e.what());
  }
}

bool Planner::OnReport(const std::string& arm, const arm_report_t& message) {
  const auto report =
      FromMessage(message, decision_maker_->rules().vocabulary(), bus_.now());
  if (!report || message.arm != arm) return false;
  decision_maker_->state().OnArmState(*report);
  return true;
}

bool Planner::OnResult(const skill_result_t& message) {
  const auto result =
      FromMessage(message, decision_maker_->rules().vocabulary(), bus_.now());
  if (result) decision_maker_->state().OnSkillResult(*result);
  return result.has_value();
}

void Planner::Publish(const Decisions& decisions) {
  const RuleSet& rules = decision_maker_->rules();
  for (const SkillRequest& request : decisions.requests) {
    skill_request_t message = ToMessage(request, rules.vocabulary());
    message.header.utime = bus_.now();
    bus_.Publish("SKILL_REQUEST", message);
  }
  if (decisions.sense) {
    bus_.Publish("SENSE_REQUEST", sense_request_t{{bus_.now(), 0, 0, 0}});
  }
  if (decisions.plan) bus_.Publish("PLAN", ToMessage(*decisions.plan, rules));
  if (decisions.execution) {
    execution_t message = ToMessage(*decisions.execution, rules);
    message.header.utime = bus_.now();
    bus_.Publish("EXECUTION", message);
  }
  for (const Alert& alert : decisions.alerts) {
    bus_.Publish("ALERT", ToMessage(alert));
  }
  if (observer_ && (decisions.plan || decisions.execution ||
                    !decisions.requests.empty() || !decisions.alerts.empty())) {
    observer_(Now(), decisions, decision_maker_->state().Basis());
  }
}

std::unique_ptr<Service> MakePlanner(Bus& bus, const Deployment& deployment) {
  return MakeObservedPlanner(bus, deployment, {});
}

std::unique_ptr<Service> MakeObservedPlanner(Bus& bus,
                                             const Deployment& deployment,
                                             DecisionObserver observer) {
  Domain domain = LoadTask(deployment).domain;
  auto decision_maker = LoadDecisionMaker(domain, deployment);
  auto planner = std::make_unique<Planner>(bus, std::move(domain),
                                           std::move(decision_maker));
  planner->SetObserver(std::move(observer));
  return planner;
}

}  // namespace cell::planner
