#pragma once

#include <vector>

#include "common/layout/arm_layout.h"

namespace cell {

/// A motion of the joints through waypoints, at rest at each of them, within
/// a speed and an acceleration: each stretch is straight in the joints and of
/// least jerk in time.
class JointTrajectory {
 public:
  struct Limits {
    double speed = 1.0;         ///< [rad/s] of the fastest joint
    double acceleration = 2.5;  ///< [rad/s^2]
  };
  struct Point {
    Joints position = Joints::Zero();  ///< [rad]
    Joints velocity = Joints::Zero();  ///< [rad/s]
  };

  /// @throws std::invalid_argument without waypoints.
  JointTrajectory(std::vector<Joints> waypoints, const Limits& limits);

  double duration() const { return ends_.back(); }  ///< [s]
  /// At rest before 0 and after the end.
  Point At(double t) const;

 private:
  std::vector<Joints> waypoints_;
  std::vector<double> ends_;  // [s] when each waypoint is reached
};

}  // namespace cell
