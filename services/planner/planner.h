#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cell/action_record_t.hpp"
#include "cell/action_t.hpp"
#include "cell/arm_report_t.hpp"
#include "cell/command_goal_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/operating_mode_t.hpp"
#include "cell/predicates_t.hpp"
#include "cell/skill_result_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/command_answer.h"
#include "common/config/deployment.h"
#include "common/relational/domain.h"
#include "services/planner/executor.h"
#include "services/planner/monitor.h"
#include "services/planner/unseen_changes.h"

namespace cell::planner {

/// The decision maker (sections VII-B, VIII-A), for the goal that EPISODE or
/// COMMAND_GOAL names. Of a person's episode: PREDICATES, ACTION -> PLAN,
/// ALERT. Of the robot's: these, ARM_REPORT_*, SKILL_RESULT and MODE ->
/// SKILL_REQUEST, SENSE_REQUEST, EXECUTION, PLAN; nobody is warned then, since
/// what fails is the robot's own. ACTION_RECORD replaces what it knows of an
/// action: it then goes on as one who joins the episode.
class Planner final : public Service {
 public:
  struct Params {
    Domain domain;
    PlanSearch::Params search;
    Monitor::Params monitor;
    UnseenChanges::Params unseen;
    Executor::Params executor;
  };

  /// `bus` must outlive this object.
  Planner(Bus& bus, Params params);

 private:
  bool OnEpisode(const episode_t& message);
  CommandAnswer OnGoal(const command_goal_t& message);
  bool OnMode(const operating_mode_t& message);
  bool OnPredicates(const predicates_t& message);
  bool OnAction(const action_t& message);
  bool OnRecord(const action_record_t& message);
  bool OnReport(const std::string& arm, const arm_report_t& message);
  bool OnResult(const skill_result_t& message);
  void Begin(Agent agent, const Goal& goal, const episode_t& episode);
  void Watch(const Goal& goal);
  void StartOver();
  void RequestSense();
  std::string NoGoal(const std::string& name) const;
  void Complain(int8_t cause, const std::string& text);
  void Decide();
  void LookForUnseen();
  void EndUnseen();
  void TellUnseen(const std::vector<std::string>& texts);
  void Publish(const Monitor::Report& report);
  void Publish(const Execution& execution);

  Bus& bus_;
  Params params_;
  std::optional<Monitor> monitor_;        // of a person's episode
  std::optional<UnseenChanges> unseen_;   // of the same
  std::optional<Executor> executor_;      // of the robot's
  std::optional<int64_t> complained_of_;  // episode
  std::string goal_;                      // of the episode
  bool has_asked_ = false;                // for records, or they come unasked
  bool is_running_ = false;               // an episode
  bool may_act_ = false;
  int64_t start_utime_ = 0;           // of the episode
  std::optional<int64_t> end_utime_;  // of the last one, until all is told
};

std::unique_ptr<Service> MakePlanner(Bus& bus, const Deployment& deployment);

}  // namespace cell::planner
