#pragma once

#include <vector>

#include "common/layout/arm_layout.h"

namespace cell {

/// Of every joint.
struct JointRates {
  double speed = 1.0;         ///< [rad/s]
  double acceleration = 2.5;  ///< [rad/s^2]
};

/// A path of waypoints in time: straight from each to the next in joint space,
/// at rest at each, all joints with one trapezoid of speed, as fast as the
/// rates of every joint allow.
class JointTrajectory {
 public:
  struct Sample {
    Joints q = Joints::Zero();
    Joints dq = Joints::Zero();  ///< [rad/s]
  };

  /// @throws std::invalid_argument without waypoints or for rates that are not
  /// positive.
  explicit JointTrajectory(const std::vector<Joints>& waypoints,
                           const JointRates& rates = {});

  /// At rest at its ends before 0 and after duration(). t in s.
  Sample At(double t) const;
  double duration() const { return duration_; }  ///< [s]
  const Joints& start() const { return start_; }
  const Joints& goal() const { return goal_; }

 private:
  /// s(t) from 0 to 1 along a segment.
  struct Segment {
    Joints from = Joints::Zero();
    Joints way = Joints::Zero();
    double begin = 0;         ///< [s]
    double ramp = 0;          ///< [s] of speeding up, and of slowing down
    double cruise = 0;        ///< [s] between them
    double acceleration = 0;  ///< of s [1/s^2]
    double duration() const { return 2 * ramp + cruise; }
  };

  std::vector<Segment> segments_;
  Joints start_ = Joints::Zero();
  Joints goal_ = Joints::Zero();
  double duration_ = 0;
};

}  // namespace cell
