#include "services/vtb/hand_path.h"

#include <algorithm>
#include <cmath>

namespace cell::vtb {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kShortest = 0.3;  // [s] of a leg

double LegDuration(double amount, double speed) {
  return std::max(kShortest, amount / speed);
}

Vector3d RotationVector(const Isometry3d& from, const Isometry3d& to) {
  const Eigen::AngleAxisd turn(to.linear() * from.linear().transpose());
  return turn.angle() * turn.axis();
}

}  // namespace

double MinimumJerk(double phase) {
  const double s = std::clamp(phase, 0.0, 1.0);
  return s * s * s * (10 - 15 * s + 6 * s * s);
}

double MinimumJerkPhase(double value) {
  double low = 0, high = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (MinimumJerk(middle) < value ? low : high) = middle;
  }
  return high;
}

void HandPath::Add(const Leg& leg) {
  legs_.push_back(leg);
  duration_ = std::max(duration_, leg.start + leg.duration);
}

void HandPath::Turn(double start, double duration, const Isometry3d& to) {
  turn_ = RotationVector(X_start_, to);
  turn_start_ = start;
  turn_duration_ = duration;
  duration_ = std::max(duration_, start + duration);
}

HandPath HandPath::Straight(const Isometry3d& from, const Isometry3d& to,
                            double duration) {
  HandPath path(from);
  path.Add(
      {0, duration, to.translation() - from.translation(), Vector3d::Zero()});
  path.Turn(0, duration, to);
  return path;
}

HandPath HandPath::About(const Isometry3d& from, const Vector3d& p_W,
                         const Vector3d& axis, double angle, double duration) {
  HandPath path(from);
  path.arc_ = {p_W, axis, angle};
  path.duration_ = duration;
  return path;
}

HandPath HandPath::Over(const Isometry3d& from, const Isometry3d& to,
                        double clear_z, double top_z, double bend,
                        const Speeds& speeds) {
  const double z0 = from.translation().z(), z1 = to.translation().z();
  const double top = std::max({z0, z1, top_z});
  const double up = top - z0, down = top - z1;
  const double up_duration = up > 0 ? LegDuration(up, speeds.along) : 0;
  const double down_duration = down > 0 ? LegDuration(down, speeds.along) : 0;
  // Across begins when up has passed the clear height, and ends before down
  // passes it.
  const auto share = [&](double way) {
    return way > 0 ? std::clamp((top - clear_z) / way, 0.0, 1.0) : 1.0;
  };
  const double across_start = up_duration * MinimumJerkPhase(1 - share(up));
  const double still_clear = down_duration * MinimumJerkPhase(share(down));
  Vector3d across = to.translation() - from.translation();
  across.z() = 0;
  const double angle = RotationVector(from, to).norm();
  const double across_duration =
      std::max(LegDuration(across.norm(), speeds.across),
               LegDuration(angle, speeds.turning));
  const double across_end = across_start + across_duration;

  HandPath path(from);
  path.Add({0, up_duration, Vector3d(0, 0, up), Vector3d::Zero()});
  path.Add({across_start, across_duration, across,
            bend * Vector3d::UnitZ().cross(across).normalized()});
  path.Add({std::max(up_duration, across_end - still_clear), down_duration,
            Vector3d(0, 0, -down), Vector3d::Zero()});
  path.Turn(across_start, across_duration, to);
  return path;
}

Isometry3d HandPath::At(double time) const {
  Isometry3d X = X_start_;
  for (const Leg& leg : legs_) {
    if (leg.duration <= 0) continue;
    const double s = MinimumJerk((time - leg.start) / leg.duration);
    X.translation() += s * leg.delta + 4 * s * (1 - s) * leg.bend;
  }
  if (turn_duration_ > 0 && turn_.norm() > 0) {
    const double s = MinimumJerk((time - turn_start_) / turn_duration_);
    X.linear() =
        Eigen::AngleAxisd(s * turn_.norm(), turn_.normalized()) * X.linear();
  }
  if (arc_.angle != 0) {
    const double s = MinimumJerk(time / duration_);
    X = Eigen::Translation3d(arc_.p_W) *
        Eigen::AngleAxisd(s * arc_.angle, arc_.axis) *
        Eigen::Translation3d(-arc_.p_W) * X;
  }
  return X;
}

}  // namespace cell::vtb
