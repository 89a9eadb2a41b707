#pragma once

#include <Eigen/Core>

#include "services/robot_arm/contact/contact_state.h"

namespace cell::robot_arm {

/// What a contact motion follows: y_DMP and f_desired of eq. 2 (section
/// VIII-B), in the frame S of the site. The translation is asked for tick by
/// tick: the reference can then stop, go on, or hand over to force control
/// without a bump in the command.
class MotionReference {
 public:
  /// One tick of the reference.
  struct Step {
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< [m] to be added
    Eigen::Matrix3d R_SO = Eigen::Matrix3d::Identity();
    double turned = 0;  ///< [rad] about -z since the beginning
    /// True if the force along z is controlled to push() in this tick.
    bool is_pressing = false;
  };

  MotionReference() = default;
  MotionReference(const MotionReference&) = delete;
  MotionReference& operator=(const MotionReference&) = delete;
  virtual ~MotionReference() = default;
  /// Goes on by a tick of `dt` [s], slowed down to `rate` in (0, 1] of its
  /// speed.
  virtual Step Advance(const ContactState& state, double rate, double dt) = 0;
  /// f_desired [N] along -z while it presses.
  virtual double push() const = 0;
};

}  // namespace cell::robot_arm
