#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cell/arm_report_t.hpp"
#include "cell/arm_state_t.hpp"
#include "cell/arm_stop_t.hpp"
#include "cell/command_mode_t.hpp"
#include "cell/skill_result_t.hpp"
#include "cell/status_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/command_answer.h"
#include "common/bus/episode_gate.h"
#include "common/config/deployment.h"
#include "services/supervisor/safety_monitor.h"

namespace cell::supervisor {

/// EPISODE, COMMAND_MODE, STATUS, ARM_REPORT_*, ARM_STATE_*, ARM_STOP_*,
/// SKILL_RESULT -> MOTION_PERMIT every tick, MODE, ALERT, ANSWER. A permit is
/// valid for so short a time that arms come to rest by themselves if this
/// service dies.
class Supervisor final : public Service {
 public:
  struct Params {
    StopPolicy table;
    int64_t permit_us = 40'000;
    std::vector<std::string> services;  ///< the roster
    std::vector<std::string> arms;      ///< of the services robot_arm@<arm>
  };

  /// `bus` must outlive this object.
  Supervisor(Bus& bus, Params params);

 private:
  bool OnEpisode(const episode_t& message);
  CommandAnswer OnCommand(const command_mode_t& message);
  bool OnStatus(const status_t& message);
  bool OnReport(const std::string& arm, const arm_report_t& message);
  bool OnState(const std::string& arm, const arm_state_t& message);
  bool OnStop(const std::string& arm, const arm_stop_t& message);
  bool OnResult(const skill_result_t& message);
  SafetyMonitor& Watch();
  void OnTick();
  void PublishPermit(const Operation& operation);
  void PublishMode(const Operation& operation);
  void Publish(const Event& event);

  Bus& bus_;
  EpisodeGate episode_;
  Params params_;
  std::optional<SafetyMonitor> monitor_;    // from the first tick on
  std::map<std::string, int8_t> servos_;    // last seen, by arm
  std::set<std::string> stopped_;           // arms, in this tick
  std::map<std::string, std::string> why_;  // they have stopped, by arm
  std::set<std::string> reporting_;         // arms
  std::optional<int64_t> held_utime_;       // last time of a hold
  std::optional<Operation> reported_;
};

std::unique_ptr<Service> MakeSupervisor(Bus& bus, const Deployment& deployment);

}  // namespace cell::supervisor
