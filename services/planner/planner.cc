#include "services/planner/planner.h"

#include <cctype>
#include <utility>
#include <vector>

#include "cell/library_request_t.hpp"
#include "cell/sense_request_t.hpp"
#include "common/actions/action_model_reader.h"
#include "common/actions/record_messages.h"
#include "common/task/shipped_experiences.h"
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

Planner::Planner(Bus& bus, Knowledge knowledge,
                 std::set<std::string> hands_of_people,
                 std::unique_ptr<DecisionMaker> decision_maker)
    : bus_(bus),
      knowledge_(std::move(knowledge)),
      hands_of_people_(std::move(hands_of_people)),
      decision_maker_(std::move(decision_maker)) {
  bus_.Subscribe<episode_t>("EPISODE",
                            [this](const auto& m) { return OnEpisode(m); });
  AnswerCommands<command_confirm_t>(
      bus_, "COMMAND_CONFIRM", [this](const auto& m) { return OnConfirm(m); });
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
  if (knowledge_.is_learning()) {
    bus_.Subscribe<experience_t>(
        "EXPERIENCE", [this](const auto& m) { return OnExperience(m); });
    bus_.Subscribe<store_answer_t>("STORED",
                                   [this](const auto& m) { OnStored(m); });
  }
  decision_maker_->SetSecModels(knowledge_.sec_models());
  const RuleSet& rules = decision_maker_->rules();
  const ArmStates arms(rules.shared_vocabulary());
  for (const int arm : arms.arms()) {
    const std::string& name = rules.vocabulary().objects()[arm].name;
    bus_.Subscribe<arm_report_t>(
        "ARM_REPORT_" + InCapitals(name),
        [this, name](const auto& m) { return OnReport(name, m); });
  }
  // After all messages.
  bus_.Every(1, 0, [this] {
    Relearn();
    Publish(decision_maker_->state().Decide(Now()));
  });
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
    demonstrations_.Clear();
    Publish(decision_maker_->OnEpisode(
        {has_joined_late, message.agent, message.goal}, Now()));
  }
  return event.has_value();
}

CommandAnswer Planner::OnConfirm(const command_confirm_t& message) {
  const DecisionMaker::Answer answer = decision_maker_->Confirm(message.action);
  if (!answer) return CommandAnswer::Refuse(answer.reason());
  return CommandAnswer::Accept("arms may do " + message.action);
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
  if (!sensed) return false;
  if (knowledge_.is_learning()) demonstrations_.Update(*sensed);
  Publish(decision_maker_->state().OnSensed(*sensed));
  return true;
}

bool Planner::OnAction(const recognised_action_t& message) {
  if (episode_.IsBefore(message.header.utime)) return true;
  Relearn();  // it may be of a record that came at the same time
  const RuleSet& rules = decision_maker_->rules();
  const auto action = FromMessage(message, rules);
  if (!action) return false;
  const auto shown = ShownActionFrom(message, hands_of_people_, rules);
  if (shown && knowledge_.is_learning()) demonstrations_.Update(*shown);
  Publish(decision_maker_->state().OnAction(*action));
  return true;
}

bool Planner::OnRecord(const action_record_t& message) {
  try {
    knowledge_.Put(cell::FromMessage(message));
    decision_maker_->SetSecModels(knowledge_.sec_models());
    return true;
  } catch (const ConfigError& e) {
    Refuse("ACTION_RECORD", e.what());
    return false;
  }
}

void Planner::OnStored(const store_answer_t& message) {
  if (message.channel != "EXPERIENCE_REQUEST" ||
      message.outcome == store_answer_t::STORED) {
    return;
  }
  Refuse("EXPERIENCE_REQUEST",
         "the library does not keep an experience: " + message.reason);
}

bool Planner::OnExperience(const experience_t& message) {
  if (message.action.empty()) {
    knowledge_.Remove(message.id);
    return true;
  }
  const auto experience =
      cell::FromMessage(message, decision_maker_->rules().vocabulary());
  if (!experience) {
    Refuse("EXPERIENCE", experience.reason());
    return false;
  }
  knowledge_.Add(message.id, *experience);
  return true;
}

void Planner::Relearn() {
  for (const TaskExperience& shown : demonstrations_.Take()) Keep(shown);
  const auto rules =
      knowledge_.TakeChange(decision_maker_->rules().version() + 1);
  if (rules == nullptr) return;
  if (knowledge_.why_not()) Refuse("EXPERIENCE", *knowledge_.why_not());
  decision_maker_->SetExperiences(knowledge_.experiences());
  const DecisionMaker::Answer answer = decision_maker_->ReplaceRules(rules);
  if (!answer) return Refuse("ACTION_RECORD", answer.reason());
  Publish(*answer);
}

void Planner::Refuse(const std::string& channel, const std::string& why) {
  bus_.Publish("ALERT", ToMessage(Alert{Alert::Cause::kBadInput, bus_.now(),
                                        channel + " " + why}));
}

void Planner::Keep(const TaskExperience& experience) {
  experience_t message =
      cell::ToMessage(experience, decision_maker_->rules().vocabulary());
  message.header.utime = bus_.now();
  bus_.Publish("EXPERIENCE_REQUEST", message);
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
    asked_skill_t message = ToMessage(request, rules.vocabulary());
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
  for (const TaskExperience& experience : decisions.experiences) {
    Keep(experience);
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
  const Task task = LoadTask(deployment);
  auto decision_maker = LoadDecisionMaker(task.domain, deployment);
  std::set<std::string> hands_of_people;
  for (const auto& hand : task.layout.hands) {
    hands_of_people.insert(hand.name);
  }
  std::vector<TaskExperience> shipped;
  if (decision_maker->is_learning()) {
    shipped = ReadShippedExperiences(deployment, task.domain);
  }
  Knowledge knowledge(task.domain, decision_maker->is_learning(), shipped);
  knowledge.SetModels(ActionModels(task.domain, task.parts, task.actions));
  auto planner = std::make_unique<Planner>(bus, std::move(knowledge),
                                           std::move(hands_of_people),
                                           std::move(decision_maker));
  planner->SetObserver(std::move(observer));
  return planner;
}

}  // namespace cell::planner
