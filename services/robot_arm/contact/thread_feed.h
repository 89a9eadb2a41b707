#pragma once

#include <Eigen/Core>

#include "services/robot_arm/contact/motion_reference.h"

namespace cell::robot_arm {

/// Turns about z of the site, clockwise seen along -z, and follows the thread
/// down. It presses all the way.
class ThreadFeed : public MotionReference {
 public:
  struct Params {
    double push = 3;    ///< [N] along -z: more than the part's play needs
    double rate = 1.3;  ///< [rad/s]
  };

  /// Begins at R_SO. `pitch`: [m] per turn.
  ThreadFeed(const Params& params, double pitch, const Eigen::Matrix3d& R_SO)
      : params_(params), pitch_(pitch), R_SO_(R_SO) {}

  Step Advance(const ContactState& state, double rate, double dt) override;
  double push() const override { return params_.push; }

 private:
  Params params_;
  double pitch_;
  Eigen::Matrix3d R_SO_;  // begin
  double angle_ = 0;
};

}  // namespace cell::robot_arm
