#include "services/vtb/hand_stage.h"

#include <algorithm>
#include <cmath>

namespace cell::vtb {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// How far below G's origin an empty hand reaches, and a tilted one.
constexpr double kTipDrop = 0.005, kTiltedDrop = 0.06;
constexpr double kSideClearance = 0.08;  // [m] beside a way across

double DistanceToSegment(const Vector2d& p, const Vector2d& a,
                         const Vector2d& b) {
  const Vector2d ab = b - a;
  const double length2 = ab.squaredNorm();
  const double s =
      length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0;
  return (p - a - s * ab).norm();
}

double Tilt(const Eigen::Matrix3d& R) {
  return std::acos(std::clamp(R(2, 2), -1.0, 1.0));
}

/// What a hand takes up on its way.
struct Sweep {
  double radius = kSideClearance;  // [m] in the plane
  double drop = 0;                 // [m] below G's origin
};

Sweep SweepOf(const Isometry3d& from, const Isometry3d& to,
              const std::optional<std::string>& held,
              const HandContext& context) {
  const bool is_tilting =
      AngleBetween(from.linear(), to.linear()) > 1e-6 &&
      (Tilt(from.linear()) > 0.1 || Tilt(to.linear()) > 0.1);
  Sweep sweep;
  sweep.drop = is_tilting ? kTiltedDrop : kTipDrop;
  if (!held) return sweep;
  const Isometry3d& X_GO = context.hand.X_GO;
  const PartExtent& extent = context.sampler.ExtentOf(*held);
  sweep.radius += X_GO.translation().head<2>().norm() + extent.radius;
  const auto hang = [&](const Isometry3d& X) {
    return X.translation().z() - extent.Lowest(X * X_GO);
  };
  sweep.drop = std::max({sweep.drop, hang(from), hang(to)});
  if (is_tilting) {
    sweep.drop =
        std::max(sweep.drop, X_GO.translation().norm() + extent.radius);
  }
  return sweep;
}

/// [m] Height of what stands within `radius` of the way across.
double HighestOnTheWay(const Vector2d& from, const Vector2d& to, double radius,
                       const std::optional<std::string>& held,
                       const HandContext& context) {
  double top = 0;
  for (const Part& other : context.world.table().parts()) {
    if (held == other.name) continue;
    const Isometry3d X_WO = context.world.PoseOf(other.name);
    const PartExtent& extent = context.sampler.ExtentOf(other.name);
    if (DistanceToSegment(X_WO.translation().head<2>(), from, to) <
        radius + extent.RadiusAcross(X_WO)) {
      top = std::max(top, extent.Highest(X_WO));
    }
  }
  return top;
}

}  // namespace

double HandState::Spread(std::mt19937_64& random) const {
  return std::uniform_real_distribution<double>(
      1 - human_motion.speed_spread, 1 + human_motion.speed_spread)(random);
}

void HandStage::Begin(HandContext& /*context*/) const {}

HandStage::Progress HandStage::Act(HandContext& context) const {
  return {Follow(context, context.run.path.duration())};
}

std::optional<Vector2d> HandStage::LeadsTo(const HandState& /*hand*/,
                                           const World& /*world*/) const {
  return std::nullopt;
}

bool Follow(HandContext& context, double duration) {
  const StageRun& run = context.run;
  context.hand.X_WG = run.path.At(run.time);
  context.hand.opening =
      run.opening_from +
      (run.opening_to - run.opening_from) * MinimumJerk(run.time / duration);
  return run.time >= duration;
}

void GoStraight(const Isometry3d& X_WG, double duration, HandContext& context) {
  context.run.path = HandPath::Straight(context.hand.X_WG, X_WG, duration);
}

void GoOver(const Isometry3d& X_WG, HandContext& context) {
  const Isometry3d& from = context.hand.X_WG;
  const HumanMotionParams& human_motion = context.hand.human_motion;
  const auto held = context.world.hands().HeldBy(context.hand.name);
  const Sweep sweep = SweepOf(from, X_WG, held, context);
  const double top = HighestOnTheWay(from.translation().head<2>(),
                                     X_WG.translation().head<2>(), sweep.radius,
                                     held, context);
  std::uniform_real_distribution<double> unit(0, 1);
  const double clear_z = top + human_motion.clearance / 2 + sweep.drop;
  const double top_z =
      clear_z + human_motion.clearance * (0.5 + unit(context.random));
  HandPath::Speeds speeds = human_motion.speeds;
  speeds.across *= context.hand.Spread(context.random);
  speeds.along *= context.hand.Spread(context.random);
  const double bend = human_motion.bend * (2 * unit(context.random) - 1);
  context.run.path = HandPath::Over(from, X_WG, clear_z, top_z, bend, speeds);
}

Isometry3d Shifted(Isometry3d X, const Vector3d& by_W) {
  X.translation() += by_W;
  return X;
}

double AngleBetween(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::AngleAxisd(a.transpose() * b).angle();
}

}  // namespace cell::vtb
