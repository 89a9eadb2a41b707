#pragma once

#include <Eigen/Core>

#include "services/robot_arm/contact/contact_wrench.h"

namespace cell::robot_arm {

/// The admittance law of section VIII-B with fixed gains,
///   y_cmd = y_DMP + K_p e_f + K_i integral(e_f dt)        (eq. 2),
/// in the frame S of a site. Sideways and in rotation f_desired is 0: the part
/// yields to what pushes it, and both terms are offsets. Along z the command
/// follows force control without a limit: that term is given tick by tick
/// (AxialStep), without K_p, since its share would be released in a jump when
/// contact is lost. Wrenches are on the part, hence e_f = f - f_desired.
class Admittance {
 public:
  /// At 125 Hz and with a stiff contact these are stable up to kp 3e-5, ki
  /// 1e-3, kp_turn 4e-3 and ki_turn 0.15.
  struct Params {
    double kp = 2e-5;          ///< [m/N] sideways
    double ki = 4e-4;          ///< [m/(N s)] sideways and along z
    double kp_turn = 2e-3;     ///< [rad/(N m)]
    double ki_turn = 0.06;     ///< [rad/(N m s)]
    double max_drift = 0.008;  ///< [m] of K_i sideways: beyond is no site
    double max_turn = 0.12;    ///< [rad] of K_i: beyond, the grip has slipped
  };

  explicit Admittance(const Params& params) : params_(params) {}

  /// One tick of `dt` [s], sideways and in rotation.
  void Step(const ContactWrench& contact, double dt);
  /// [m] along z in a tick in which the force there is `error` [N] more than
  /// desired. Towards the seat it goes at `rate` of its speed, away from it at
  /// once.
  double AxialStep(double error, double rate, double dt) const;

  /// K_p e_f and K_i integral(e_f dt) sideways [m].
  const Eigen::Vector2d& proportional() const { return proportional_; }
  const Eigen::Vector2d& integral() const { return integral_; }
  /// Both terms in rotation [rad], a rotation vector.
  Eigen::Vector3d Turn() const { return turn_proportional_ + turn_integral_; }

 private:
  Params params_;
  Eigen::Vector2d proportional_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d integral_ = Eigen::Vector2d::Zero();
  Eigen::Vector3d turn_proportional_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d turn_integral_ = Eigen::Vector3d::Zero();
};

}  // namespace cell::robot_arm
