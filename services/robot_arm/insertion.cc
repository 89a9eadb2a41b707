#include "services/robot_arm/insertion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/layout/limit_words.h"

namespace cell::robot_arm {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kTouching = 0.3;      // of the push: there is contact
constexpr double kLoose = 0.1;         // of the push: there is none ...
constexpr double kLooseTime = 0.2;     // [s] ... after so long
constexpr double kPushing = 0.6;       // of the push: it does not yield
constexpr double kStallTime = 0.3;     // [s]
constexpr double kStallMove = 0.0003;  // [m] less than that is no advance
constexpr double kFound = 0.0007;      // [m] that it sinks in a search
constexpr int kMaxSpirals = 4;
constexpr double kMaxTurn = 0.12;    // [rad] of the compliance
constexpr double kMaxDrift = 0.008;  // [m]
constexpr double kYawPeriod = 0.7, kTiltPeriod = 0.9;  // [s]
constexpr double kDitherRise = 0.15;  // [s] from none to all of it, and back

template <class V>
V Limited(const V& v, double length) {
  const double norm = v.norm();
  return norm > length ? V(v * (length / norm)) : v;
}

}  // namespace

Insertion::Insertion(const Params& params, double height)
    : params_(params), z_(height), stall_height_(height) {}

void Insertion::Fail(const std::string& reason) {
  state_ = State::kFailed;
  reason_ = reason;
}

Insertion::State Insertion::Step(const ContactWrench& contact, double height,
                                 double dt) {
  if (state_ != State::kRunning) return state_;
  time_ += dt;
  const double force = contact.force.norm();
  peak_force_ = std::max(peak_force_, force);
  if (force > params_.max_force) {
    Fail("the wrist sensor measured " +
         Exceeded(force, params_.max_force, "N") + " (max_force)");
    return state_;
  }
  if (time_ > params_.timeout) {
    Fail(fmt::format(
        "it is {:.1f} mm from its seat after the {:.0f} s allowed (timeout_s)",
        1e3 * (height - params_.end_height), params_.timeout));
    return state_;
  }
  Watch(contact, height, dt);
  if (state_ != State::kRunning) return state_;
  MoveDown(contact, dt);
  Comply(contact, dt);
  Search(height, dt);
  Dither(dt);
  return state_;
}

/// Along z: at the feed until there is contact, then by force (eq. 2, its
/// integral part).
void Insertion::MoveDown(const ContactWrench& contact, double dt) {
  const double sideways = contact.force.head<2>().norm();
  const double slow =
      1 / (1 + params_.slow_down *
                   std::max(0.0, sideways - params_.slow_down_dead));
  const double force = contact.force.z();
  if (force > kTouching * params_.push) is_in_air_ = false;
  time_without_touch_ =
      force < kLoose * params_.push ? time_without_touch_ + dt : 0;
  if (time_without_touch_ > kLooseTime) is_in_air_ = true;
  double speed = params_.ki * (params_.push - force);
  if (is_in_air_) {
    speed = std::max(
        speed, z_ > params_.touch_height ? params_.feed : params_.touch_feed);
  }
  z_ -= (speed > 0 ? slow * speed : speed) * dt;
}

/// Sideways and in rotation: yields to what pushes, eq. 2 with f_desired 0.
void Insertion::Comply(const ContactWrench& contact, double dt) {
  spring_ = params_.kp * contact.force.head<2>();
  drift_ = Limited<Vector2d>(drift_ + params_.ki * dt * contact.force.head<2>(),
                             kMaxDrift);
  turn_spring_ = params_.kp_turn * contact.torque;
  turn_drift_ = Limited<Vector3d>(
      turn_drift_ + params_.ki_turn * dt * contact.torque, kMaxTurn);
}

/// Sees that it is done, or that it stalls.
void Insertion::Watch(const ContactWrench& contact, double height, double dt) {
  const bool is_pushing = contact.force.z() > kPushing * params_.push;
  if (!is_pushing || std::abs(height - stall_height_) > kStallMove) {
    stall_time_ = 0;
    stall_height_ = height;
    return;
  }
  stall_time_ += dt;
  if (stall_time_ < kStallTime) return;
  const double left = height - params_.end_height;
  if (left <= params_.tolerance && left >= -params_.tolerance - params_.give) {
    state_ = State::kDone;
    return;
  }
  if (!params_.is_searching) {
    Fail(
        fmt::format("it is stuck {:.1f} mm from its seat, {:.1f} mm allowed "
                    "(tolerance_mm), by {:.1f} N at the wrist sensor",
                    1e3 * left, 1e3 * params_.tolerance, contact.force.norm()));
    return;
  }
  if (spiral_angle_ >= 0) return;
  spiral_angle_ = 0;
  spiral_height_ = height;
  ++num_spirals_;
}

/// Ever wider circles until it sinks in; what was found becomes the middle.
void Insertion::Search(double height, double dt) {
  if (spiral_angle_ < 0) return;
  const double turns = spiral_angle_ / (2 * std::numbers::pi);
  const double radius = params_.spiral_pitch * turns;
  if (height < spiral_height_ - kFound) {
    base_ +=
        radius * Vector2d(std::cos(spiral_angle_), std::sin(spiral_angle_));
    spiral_angle_ = -1;
    stall_time_ = 0;
    return;
  }
  spiral_angle_ +=
      params_.spiral_speed * dt / std::max(radius, params_.spiral_pitch / 2);
  if (radius < params_.spiral_radius) return;
  spiral_angle_ = 0;
  if (++num_spirals_ > kMaxSpirals) {
    Fail(
        fmt::format("{} searches, as many as allowed, have found no way in, "
                    "{:.1f} mm from the seat",
                    kMaxSpirals, 1e3 * (height - params_.end_height)));
  }
}

/// Comes and goes gently: a joint cannot jump.
void Insertion::Dither(double dt) {
  const bool is_stalled = stall_time_ > 0 || spiral_angle_ >= 0;
  const double step = dt / kDitherRise;
  dither_ = std::clamp(dither_ + (is_stalled ? step : -step), 0.0, 1.0);
}

Eigen::Isometry3d Insertion::X_SO() const {
  Vector2d offset = base_ + spring_ + drift_;
  Vector3d turn = turn_spring_ + turn_drift_;
  if (spiral_angle_ >= 0) {
    const double radius =
        params_.spiral_pitch * spiral_angle_ / (2 * std::numbers::pi);
    offset +=
        radius * Vector2d(std::cos(spiral_angle_), std::sin(spiral_angle_));
  }
  const double phase = 2 * std::numbers::pi * time_;
  turn.z() += dither_ * params_.yaw_dither * std::sin(phase / kYawPeriod);
  turn.x() += dither_ * params_.tilt_dither * std::sin(phase / kTiltPeriod);
  turn.y() += dither_ * params_.tilt_dither * std::cos(phase / kTiltPeriod);
  Eigen::Isometry3d X_SO = Eigen::Isometry3d::Identity();
  X_SO.translation() << offset, z_;
  const double angle = turn.norm();
  if (angle > 0) X_SO.linear() = AngleAxisd(angle, turn / angle).matrix();
  return X_SO;
}

}  // namespace cell::robot_arm
