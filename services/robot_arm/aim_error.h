#pragma once

#include <Eigen/Geometry>
#include <cstdint>

namespace cell::robot_arm {

/// By how much an arm is wrong about where a site is: another error for each
/// request, the same for the same request. None, except where an evaluation
/// asks how much is borne.
struct AimError {
  double offset = 0;  ///< [m] sideways: root mean square of the vector's length
  double angle = 0;   ///< [rad] about any axis: the same of the rotation vector
  uint64_t seed = 0;

  /// X_SE: where the arm believes the site S to be.
  Eigen::Isometry3d Of(int64_t request) const;
};

}  // namespace cell::robot_arm
