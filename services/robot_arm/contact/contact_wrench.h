#pragma once

#include <Eigen/Core>

namespace cell::robot_arm {

/// What touches a held part, in the axes of its site: on the part, positive.
struct ContactWrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< [N]
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();  ///< [N m] about its origin
};

}  // namespace cell::robot_arm
