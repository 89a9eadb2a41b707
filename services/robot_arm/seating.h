#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "services/robot_arm/contact_sensor.h"
#include "services/robot_arm/insertion.h"
#include "services/robot_arm/skill_stage.h"
#include "services/robot_arm/tool_kinematics.h"
#include "services/robot_arm/turning.h"

namespace cell::robot_arm {

/// Frames of a part in a gripper on its way to a site.
struct SeatingFrames {
  Eigen::Isometry3d X_WS = Eigen::Isometry3d::Identity();  ///< of the site
  Eigen::Isometry3d X_GO = Eigen::Isometry3d::Identity();  ///< of the part
  /// The rotation about z of S that the part is seated with.
  Eigen::Isometry3d X_symmetry = Eigen::Isometry3d::Identity();

  /// Where the gripper is when the part is at X_SO, turned so.
  Eigen::Isometry3d GripperAt(const Eigen::Isometry3d& X_SO) const;
  /// Height of the part's origin over the site.
  double HeightAt(const Eigen::Isometry3d& X_WG) const;
};

/// Runs an Insertion on an arm.
class Insert : public SkillStage {
 public:
  /// `kinematics` and `sensor` must outlive this object; `peak_force` gets the
  /// highest force so far.
  Insert(const ToolKinematics& kinematics, const SeatingFrames& frames,
         const Insertion::Params& params, const ContactSensor& sensor,
         double* peak_force);
  State Step(const ArmReading& reading, double dt,
             ArmCommand* command) override;
  std::string reason() const override { return reason_; }

 private:
  const ToolKinematics& kinematics_;
  SeatingFrames frames_;
  Insertion::Params params_;
  const ContactSensor& sensor_;
  double* peak_force_;
  std::optional<Insertion> insertion_;
  double silence_ = 0;  // [s] without a reading of the sensor
  std::string reason_;
};

/// Runs a Turning on an arm.
class Turn : public SkillStage {
 public:
  Turn(const ToolKinematics& kinematics, const SeatingFrames& frames,
       const Turning::Params& params, const ContactSensor& sensor);
  State Step(const ArmReading& reading, double dt,
             ArmCommand* command) override;
  std::string reason() const override { return reason_; }

 private:
  const ToolKinematics& kinematics_;
  SeatingFrames frames_;
  Turning::Params params_;
  const ContactSensor& sensor_;
  std::optional<Turning> turning_;
  double silence_ = 0;
  std::string reason_;
};

}  // namespace cell::robot_arm
