#pragma once

#include <Eigen/Geometry>
#include <string>

#include "services/robot_arm/insertion.h"

namespace cell::robot_arm {

/// Turns a held part home on a thread: about z of its site, clockwise seen
/// along -z, following the thread down, until the torque says that it is home.
/// What carries the thread may shift a little: the height says nothing then.
/// Frame S of the site. Pure.
class Turning {
 public:
  struct Params {
    double rate = 1.3;        ///< [rad/s]
    double pitch = 0.008;     ///< [m] per turn
    double push = 3;          ///< [N] along -z
    double kp = 2e-5;         ///< [m/N] sideways
    double ki = 4e-4;         ///< [m/(N s)] all along
    double min_angle = 4.5;   ///< [rad] tight before that: it has jammed
    double max_angle = 8.4;   ///< [rad]
    double max_torque = 0.4;  ///< [N m] about z: it is tight
  };
  enum class State { kRunning, kDone, kFailed };

  /// Begins with the part at X_SO.
  Turning(const Params& params, const Eigen::Isometry3d& X_SO);

  /// One tick of `dt` [s]. `height`: z of O in S as measured.
  State Step(const ContactWrench& contact, double height, double dt);

  /// Where the part shall be.
  Eigen::Isometry3d X_SO() const;
  const std::string& reason() const { return reason_; }
  double angle() const { return angle_; }  ///< [rad] turned so far

 private:
  Params params_;
  Eigen::Isometry3d X_SO_;  // begin
  double angle_ = 0;
  double z_;
  Eigen::Vector2d spring_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d drift_ = Eigen::Vector2d::Zero();
  State state_ = State::kRunning;
  std::string reason_;
};

}  // namespace cell::robot_arm
