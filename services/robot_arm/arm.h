#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>

#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "services/robot_arm/arm_reading.h"
#include "services/robot_arm/contact_sensor.h"
#include "services/robot_arm/motion_client.h"
#include "services/robot_arm/scene_monitor.h"
#include "services/robot_arm/skill_settings.h"
#include "services/robot_arm/tool_kinematics.h"

namespace cell::robot_arm {

/// An arm as its skills know it: what it is, senses, holds and is commanded.
/// Outlives every skill.
class Arm {
 public:
  struct Params {
    std::string arm;
    CellLayout layout;
    PartTable parts;
    SkillSettings settings;
  };
  explicit Arm(const Params& params);
  Arm(const Arm&) = delete;
  Arm& operator=(const Arm&) = delete;

  const Params& params() const { return params_; }
  const ArmLayout& layout() const { return layout_; }
  const PartTable& parts() const { return params_.parts; }
  const SkillSettings& settings() const { return params_.settings; }
  const std::map<std::string, Eigen::Isometry3d>& poses() const {
    return monitor_.poses();
  }
  bool has_force_sensor() const { return layout_.X_FS.has_value(); }
  const ToolKinematics& kinematics() const { return kinematics_; }
  ContactSensor& sensor() { return sensor_; }
  SceneMonitor& monitor() { return monitor_; }
  MotionClient& client() { return client_; }

  /// One tick of `dt` [s] with the readings of its devices.
  void Update(const ArmReading& reading, double dt);
  const ArmReading& reading() const { return reading_; }
  /// Its next command. @pre is_known().
  ArmCommand& command() { return *command_; }
  const ArmCommand& command() const { return *command_; }
  /// True once its device has sent a state.
  bool is_known() const { return command_.has_value(); }

  /// The part in the gripper; nothing: none, or it is not known which.
  const std::optional<HeldPart>& held() const { return held_; }
  void Hold(HeldPart held);
  /// The hand is empty, or it is not known what is in it.
  void ForgetHeld();
  /// The site that holds what the gripper holds; nullptr if there is none.
  const Site* SiteOfHeld() const;
  /// Once it has been at rest for a while: the part that the fingers hold, if
  /// they held it before this process started.
  void RecogniseHeld();
  /// The part that the fingers are around.
  std::optional<std::string> FindGrasped() const;

  /// True if it may be among parts: it draws back before it turns away.
  /// Nothing: not known, e.g. after a stop.
  std::optional<bool> is_near;
  bool is_releasing = false;  ///< that it holds nothing soon is no loss

 private:
  Params params_;
  const ArmLayout& layout_;  // in params_
  ToolKinematics kinematics_;
  ContactSensor sensor_;  // of the kinematics
  SceneMonitor monitor_;
  MotionClient client_;
  ArmReading reading_;
  std::optional<ArmCommand> command_;
  std::optional<HeldPart> held_;
  double still_ = 0;  // [s] that it has been at rest
};

}  // namespace cell::robot_arm
