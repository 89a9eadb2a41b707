#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cell/arm_report_t.hpp"
#include "cell/arm_state_t.hpp"
#include "cell/arm_stop_t.hpp"
#include "cell/asked_skill_t.hpp"
#include "cell/motion_permit_t.hpp"
#include "cell/motion_plan_t.hpp"
#include "cell/skill_traits_t.hpp"
#include "cell/tracks_t.hpp"
#include "cell/wrench_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/episode_gate.h"
#include "common/bus/input_alerts.h"
#include "common/config/deployment.h"
#include "common/scene/scene_objects.h"
#include "services/robot_arm/arm_worker.h"

namespace cell::robot_arm {

/// One arm's skills (section VIII): SKILL_REQUEST, TRACKS and messages of its
/// device in; ARM_SETPOINT_<ARM> every tick, ARM_REPORT_<ARM> and SKILL_RESULT
/// out. It asks for paths by MOTION_REQUEST, and waits for the MOTION_PLAN. It
/// moves only while MOTION_PERMIT allows it.
class RobotArm final : public Service {
 public:
  struct Params {
    ArmWorker::Params worker;
    SceneObjects scene_objects;
  };

  /// `bus` must outlive this object.
  RobotArm(Bus& bus, const Params& params);

 private:
  bool OnEpisode(const episode_t& message);
  const ArmModel& ModelOf(const std::string& arm) const;
  bool OnState(const arm_state_t& message);
  bool OnOther(const std::string& arm, const arm_state_t& message);
  bool OnStop(const arm_stop_t& message);
  bool OnWrench(const wrench_t& message);
  bool OnPermit(const motion_permit_t& message);
  bool OnTracks(const tracks_t& message);
  bool OnRequest(const asked_skill_t& message);
  bool OnPlan(const motion_plan_t& message);
  void OnTick();
  void PublishSetpoint(const ArmCommand& command);
  void PublishResult(const SkillResult& result);
  void PublishReport();
  ArmWorker::MotionPermission Permission() const;

  struct SensedAt {
    ArmReading::SensedWrench wrench;
    int64_t utime = 0;  ///< of its arrival
  };
  Bus& bus_;
  EpisodeGate episode_;
  Params params_;
  std::string name_, suffix_;  // suffix_: of its channels
  std::vector<skill_traits_t> skills_;
  std::unique_ptr<ArmWorker> worker_;   // of the episode
  std::optional<int64_t> start_utime_;  // of its work
  std::optional<ArmReading> reading_;
  std::optional<SensedAt> wrench_;
  std::string why_stopped_ = "its device gave no reason";
  std::optional<motion_permit_t> permit_;
  bool was_held_ = false;  // the cell, by the supervisor
  arm_report_t last_report_{};
  InputAlerts alerts_;
};

/// The arm `instance` of the task's cell.yaml.
std::unique_ptr<Service> MakeRobotArm(Bus& bus, const Deployment& deployment,
                                      const std::string& instance);

}  // namespace cell::robot_arm
