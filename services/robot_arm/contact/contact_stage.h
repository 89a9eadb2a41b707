#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <string>

#include "services/robot_arm/contact/contact_motion.h"
#include "services/robot_arm/contact/site_frames.h"
#include "services/robot_arm/contact_sensor.h"
#include "services/robot_arm/skill_stage.h"
#include "services/robot_arm/tool_kinematics.h"

namespace cell::robot_arm {

/// Begins a contact motion with the gripper at X_WG.
using ContactMotionMaker = std::function<ContactMotion(
    const SiteFrames& frames, const Eigen::Isometry3d& X_WG)>;

/// Runs a contact motion on an arm.
class ContactStage : public SkillStage {
 public:
  /// `kinematics` and `sensor` must outlive this object; `peak_force` gets the
  /// highest force so far.
  ContactStage(const ToolKinematics& kinematics, const ContactSensor& sensor,
               const SiteFrames& frames, ContactMotionMaker maker,
               double* peak_force);
  State Step(const ArmReading& reading, double dt,
             ArmCommand* command) override;
  Failure failure() const override { return {reason_}; }

 private:
  const ToolKinematics& kinematics_;
  const ContactSensor& sensor_;
  SiteFrames frames_;
  ContactMotionMaker maker_;
  double* peak_force_;
  std::optional<ContactMotion> motion_;
  double silence_ = 0;  // [s] without a reading of the sensor
  std::string reason_;
};

}  // namespace cell::robot_arm
