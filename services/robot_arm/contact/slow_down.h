#pragma once

#include <Eigen/Core>

namespace cell::robot_arm {

/// Slows a motion down where force errors grow, so that the admittance has the
/// time to take them away (section VIII-B: the slow-down of the phase).
class SlowDown {
 public:
  struct Params {
    double gain = 0.3;  ///< [1/N] 0: it never slows down
    double dead = 3;    ///< [N] that friction alone makes
  };

  explicit SlowDown(const Params& params) : params_(params) {}

  /// Share in (0, 1] of the full speed: 1 / (1 + gain max(0, |f| - dead)).
  /// `sideways`: [N] the error of the force across the motion.
  double Rate(const Eigen::Vector2d& sideways) const;

 private:
  Params params_;
};

}  // namespace cell::robot_arm
