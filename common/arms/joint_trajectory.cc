#include "common/arms/joint_trajectory.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace cell {
namespace {

// Of s(t) = 10 t^3 - 15 t^4 + 6 t^5 over [0, 1].
constexpr double kPeakSpeed = 1.875;
constexpr double kPeakAcceleration = 5.773502691896258;  // 10 / sqrt(3)

}  // namespace

JointTrajectory::JointTrajectory(std::vector<Joints> waypoints,
                                 const Limits& limits)
    : waypoints_(std::move(waypoints)) {
  if (waypoints_.empty()) throw std::invalid_argument("no waypoints");
  ends_.push_back(0);
  for (size_t i = 1; i < waypoints_.size(); ++i) {
    const double way =
        (waypoints_[i] - waypoints_[i - 1]).cwiseAbs().maxCoeff();
    ends_.push_back(ends_.back() + std::max(kPeakSpeed * way / limits.speed,
                                            std::sqrt(kPeakAcceleration * way /
                                                      limits.acceleration)));
  }
}

JointTrajectory::Point JointTrajectory::At(double t) const {
  const auto end = std::ranges::upper_bound(ends_, t);
  if (end == ends_.end()) return {waypoints_.back(), Joints::Zero()};
  if (end == ends_.begin()) return {waypoints_.front(), Joints::Zero()};
  const auto i = static_cast<size_t>(end - ends_.begin());
  const double duration = ends_[i] - ends_[i - 1];
  const double s = (t - ends_[i - 1]) / duration;
  const Joints way = waypoints_[i] - waypoints_[i - 1];
  return {waypoints_[i - 1] + s * s * s * (10 + s * (-15 + 6 * s)) * way,
          30 * s * s * (1 + s * (-2 + s)) / duration * way};
}

}  // namespace cell
