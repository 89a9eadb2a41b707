#include "services/robot_arm/turning.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "common/layout/limit_words.h"

namespace cell::robot_arm {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

}  // namespace

Turning::Turning(const Params& params, const Eigen::Isometry3d& X_SO)
    : params_(params), X_SO_(X_SO), z_(X_SO.translation().z()) {}

Turning::State Turning::Step(const ContactWrench& contact, double height,
                             double dt) {
  if (state_ != State::kRunning) return state_;
  if (std::abs(contact.torque.z()) > params_.max_torque) {
    state_ = angle_ >= params_.min_angle ? State::kDone : State::kFailed;
    reason_ = fmt::format(
        "the thread has jammed {:.1f} mm from its seat: the wrist sensor "
        "measured {} (max_torque) after {:.0f} deg, at least {:.0f} deg are "
        "wanted (min_angle_deg)",
        1e3 * height,
        Exceeded(std::abs(contact.torque.z()), params_.max_torque, "N m"),
        angle_ * kDegrees, params_.min_angle * kDegrees);
    return state_;
  }
  if (angle_ >= params_.max_angle) {
    state_ = State::kFailed;
    reason_ = fmt::format(
        "it has turned by the {:.0f} deg allowed (max_angle_deg), the wrist "
        "sensor measured {:.2f} N m of the {:.2f} N m that mean tight "
        "(max_torque): the thread does not hold",
        params_.max_angle * kDegrees, std::abs(contact.torque.z()),
        params_.max_torque);
    return state_;
  }
  angle_ += params_.rate * dt;
  const double sink = params_.pitch * params_.rate / (2 * std::numbers::pi);
  z_ -= sink * dt + params_.ki * (params_.push - contact.force.z()) * dt;
  spring_ = params_.kp * contact.force.head<2>();
  drift_ += params_.ki * dt * contact.force.head<2>();
  return state_;
}

Eigen::Isometry3d Turning::X_SO() const {
  Eigen::Isometry3d X_SO = X_SO_;
  X_SO.linear() =
      Eigen::AngleAxisd(-angle_, Eigen::Vector3d::UnitZ()) * X_SO_.linear();
  X_SO.translation().head<2>() += spring_ + drift_;
  X_SO.translation().z() = z_;
  return X_SO;
}

}  // namespace cell::robot_arm
