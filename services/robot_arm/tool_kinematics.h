#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "common/layout/arm_layout.h"

namespace cell::robot_arm {

/// Where an arm's gripper and sensor are, and which joints bring it somewhere.
class ToolKinematics {
 public:
  explicit ToolKinematics(const ArmLayout& layout);

  Eigen::Isometry3d GripperPose(const Joints& q) const;  ///< X_WG
  /// X_WS of the sensor. @pre the arm has one.
  Eigen::Isometry3d SensorPose(const Joints& q) const;
  /// The joints for a gripper pose that go on from `q` without a jump; nothing
  /// if there are none within the limits.
  std::optional<Joints> JointsNear(const Eigen::Isometry3d& X_WG,
                                   const Joints& q) const;

 private:
  ArmLayout layout_;
};

}  // namespace cell::robot_arm
