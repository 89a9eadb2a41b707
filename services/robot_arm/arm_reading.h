#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "common/layout/arm_layout.h"

namespace cell::robot_arm {

/// The readings of an arm's servos, gripper and sensor in a tick.
struct ArmReading {
  Joints q = Joints::Zero();   ///< [rad]
  Joints dq = Joints::Zero();  ///< [rad/s]
  double opening = 0;          ///< [m]
  std::string stance;          ///< of the fingers: a grip of the hand's type
  bool is_gripping = false;
  bool is_stopped = false;  ///< protective stop
  std::string why_stopped;  ///< which limit, what was measured
  /// In S, as read: with bias and weights. Nothing: no sensor, or it is silent.
  struct SensedWrench {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
    Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< [N m]
  };
  std::optional<SensedWrench> wrench;
};

/// The command to an arm for the next tick.
struct ArmCommand {
  Joints q = Joints::Zero();
  double opening = 0;
  std::string grip;
};

}  // namespace cell::robot_arm
