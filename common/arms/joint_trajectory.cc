#include "common/arms/joint_trajectory.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cell {
namespace {

constexpr double kNoWay = 1e-9;  // [rad]

}  // namespace

JointTrajectory::JointTrajectory(const std::vector<Joints>& waypoints,
                                 const JointRates& rates) {
  if (waypoints.empty()) throw std::invalid_argument("a path has no waypoints");
  if (!(rates.speed > 0 && rates.acceleration > 0)) {
    throw std::invalid_argument("joint rates must be positive");
  }
  start_ = waypoints.front();
  goal_ = waypoints.back();
  for (size_t i = 1; i < waypoints.size(); ++i) {
    Segment segment;
    segment.from = waypoints[i - 1];
    segment.way = waypoints[i] - waypoints[i - 1];
    // The joint with the longest way decides: all have the same rates.
    const double longest = segment.way.cwiseAbs().maxCoeff();
    if (longest < kNoWay) continue;
    const double speed = rates.speed / longest;
    segment.acceleration = rates.acceleration / longest;
    // s = acceleration ramp^2 + speed cruise = 1
    segment.ramp = std::min(speed / segment.acceleration,
                            std::sqrt(1 / segment.acceleration));
    const double top_speed = segment.acceleration * segment.ramp;
    segment.cruise = std::max(0.0, 1 / top_speed - segment.ramp);
    segment.begin = duration_;
    duration_ += segment.duration();
    segments_.push_back(segment);
  }
}

JointTrajectory::Sample JointTrajectory::At(double t) const {
  if (t <= 0 || segments_.empty()) return {start_, Joints::Zero()};
  if (t >= duration_) return {goal_, Joints::Zero()};
  const auto after =
      std::ranges::upper_bound(segments_, t, {}, &Segment::begin);
  const Segment& segment = *std::prev(after);
  const double since = t - segment.begin;
  const double left = segment.duration() - since;
  const double a = segment.acceleration, ramp = segment.ramp;
  double s = 0, ds = 0;
  if (since < ramp) {
    s = a * since * since / 2;
    ds = a * since;
  } else if (left < ramp) {
    s = 1 - a * left * left / 2;
    ds = a * left;
  } else {
    s = a * ramp * (since - ramp / 2);
    ds = a * ramp;
  }
  return {segment.from + s * segment.way, ds * segment.way};
}

}  // namespace cell
