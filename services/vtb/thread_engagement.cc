#include "services/vtb/thread_engagement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cell::vtb {
namespace {

double AngleAboutZ(const Eigen::Matrix3d& R) {
  return std::atan2(R(1, 0) - R(0, 1), R(0, 0) + R(1, 1));
}

}  // namespace

void ThreadEngagement::Update(const Eigen::Isometry3d& X_SO, bool is_held) {
  Memory& m = memory_;
  const double angle = AngleAboutZ(X_SO.linear());
  const bool is_taken = is_held && !m.was_held;
  m.was_held = is_held;
  if (m.state == State::kOpen) {
    if (!TakesHold(X_SO)) return;
    m = {State::kEngaged, X_SO.translation().z(), angle, is_held};
    return;
  }
  if (m.state == State::kFrozen) {
    if (!is_taken) return;
    m.state = State::kEngaged;
    m.angle = angle;
  }
  if (!is_held) {
    m.state = State::kFrozen;
    return;
  }
  const double turn = std::remainder(angle - m.angle, 2 * std::numbers::pi);
  m.angle = angle;
  m.remaining += thread_.pitch * turn / (2 * std::numbers::pi);
  if (m.remaining <= 0) {
    m.remaining = 0;
    m.state = turn < 0 ? State::kFrozen : State::kEngaged;
  } else if (m.remaining > thread_.engagement + thread_.pitch / 8) {
    m.state = State::kOpen;
  }
}

bool ThreadEngagement::TakesHold(const Eigen::Isometry3d& X_SO) const {
  const Eigen::Vector3d p = X_SO.translation();
  const double tilt = std::acos(std::clamp(X_SO.linear()(2, 2), -1.0, 1.0));
  return p.z() >= 0 && p.z() <= thread_.engagement &&
         p.head<2>().norm() <= thread_.max_offset && tilt <= thread_.max_tilt;
}

Eigen::Isometry3d ThreadEngagement::X_SO() const {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation().z() = memory_.remaining;
  X.linear() = Eigen::AngleAxisd(memory_.angle, Eigen::Vector3d::UnitZ())
                   .toRotationMatrix();
  return X;
}

}  // namespace cell::vtb
