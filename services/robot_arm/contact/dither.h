#pragma once

#include <Eigen/Core>

namespace cell::robot_arm {

/// Small turns to and fro that free a part where it sticks. They come and go
/// gently: a joint cannot jump.
class Dither {
 public:
  struct Params {
    double yaw = 0;   ///< [rad] about z: of a square fit
    double tilt = 0;  ///< [rad] about x and y: of several fits at once
    /// [s] Not multiples of each other: all corners are reached.
    double yaw_period = 0.7, tilt_period = 0.9;
    double rise_time = 0.15;  ///< [s] from none to all of it, and back
  };

  explicit Dither(const Params& params) : params_(params) {}

  /// One tick of `dt` [s] in which it is wanted, or not.
  void Step(bool is_wanted, double dt);
  /// A rotation vector [rad] at `time` [s].
  Eigen::Vector3d Turn(double time) const;

 private:
  Params params_;
  double share_ = 0;  // of the amplitudes
};

}  // namespace cell::robot_arm
