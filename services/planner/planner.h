#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>

#include "cell/action_record_t.hpp"
#include "cell/arm_report_t.hpp"
#include "cell/command_confirm_t.hpp"
#include "cell/command_goal_t.hpp"
#include "cell/experience_t.hpp"
#include "cell/operating_mode_t.hpp"
#include "cell/predicates_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "cell/skill_result_t.hpp"
#include "cell/store_answer_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/command_answer.h"
#include "common/bus/episode_gate.h"
#include "common/config/deployment.h"
#include "services/planner/decision_basis.h"
#include "services/planner/decision_maker.h"
#include "services/planner/demonstrations.h"
#include "services/planner/knowledge.h"

namespace cell::planner {

/// The decision maker as a service, for the goal that EPISODE or COMMAND_GOAL
/// names. Of a person's episode: PREDICATES, ACTION -> PLAN, ALERT. Of the
/// robot's: these, ARM_REPORT_*, SKILL_RESULT and MODE -> SKILL_REQUEST,
/// SENSE_REQUEST, EXECUTION, PLAN; no warnings then, since failures are the
/// robot's own. ACTION_RECORD replaces what it knows of an action.
class Planner final : public Service {
 public:
  /// `bus` must outlive this object.
  /// @param hands_of_people  the other hands are the arms'
  Planner(Bus& bus, Knowledge knowledge, std::set<std::string> hands_of_people,
          std::unique_ptr<DecisionMaker> decision_maker);

  /// Is told of all decisions from now on.
  void SetObserver(DecisionObserver observer) {
    observer_ = std::move(observer);
  }

 private:
  bool OnEpisode(const episode_t& message);
  CommandAnswer OnConfirm(const command_confirm_t& message);
  CommandAnswer OnGoal(const command_goal_t& message);
  bool OnMode(const operating_mode_t& message);
  bool OnPredicates(const predicates_t& message);
  bool OnAction(const recognised_action_t& message);
  bool OnRecord(const action_record_t& message);
  bool OnExperience(const experience_t& message);
  void OnStored(const store_answer_t& message);
  bool OnReport(const std::string& arm, const arm_report_t& message);
  bool OnResult(const skill_result_t& message);
  Instant Now() const { return {bus_.now(), bus_.tick()}; }
  /// Goes on by what has been learned since the last call.
  void Relearn();
  void Refuse(const std::string& channel, const std::string& why);
  void Publish(const Decisions& decisions);
  void Keep(const TaskExperience& experience);

  Bus& bus_;
  EpisodeGate episode_;
  Knowledge knowledge_;
  std::set<std::string> hands_of_people_;
  Demonstrations demonstrations_;  // of the episode
  std::unique_ptr<DecisionMaker> decision_maker_;
  DecisionObserver observer_;
};

std::unique_ptr<Service> MakePlanner(Bus& bus, const Deployment& deployment);
/// One whose decisions are observed; it decides the same.
std::unique_ptr<Service> MakeObservedPlanner(Bus& bus,
                                             const Deployment& deployment,
                                             DecisionObserver observer);

}  // namespace cell::planner
