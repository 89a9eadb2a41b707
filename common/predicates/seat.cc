#include "common/predicates/seat.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/geometry/degree.h"

namespace cell {
namespace {

double AngleOfAxes(const Eigen::Isometry3d& X_AB) {
  const Eigen::Vector3d z = X_AB.linear().col(2);
  return std::atan2(z.head<2>().norm(), z.z());
}

}  // namespace

SeatTolerance SeatTolerance::FromConfig(const Config& config) {
  SeatTolerance tolerance;
  tolerance.z = config.Number("z_mm", 0, 1000) * 1e-3;
  tolerance.xy = config.Number("xy_mm", 0, 1000) * 1e-3;
  tolerance.tilt = config.Number("tilt_deg", 0, 90) * kDegree;
  tolerance.yaw = config.Number("yaw_deg", 0, 180) * kDegree;
  return tolerance;
}

bool IsSeated(const Eigen::Isometry3d& X_SO, int symmetry_order,
              const SeatTolerance& tolerance) {
  const Eigen::Vector3d p = X_SO.translation();
  if (std::abs(p.z()) > tolerance.z || p.head<2>().norm() > tolerance.xy ||
      AngleOfAxes(X_SO) > tolerance.tilt) {
    return false;
  }
  if (symmetry_order == 0) return true;
  const Eigen::Matrix3d R = X_SO.linear();
  const double yaw = std::atan2(R(1, 0) - R(0, 1), R(0, 0) + R(1, 1));
  const double period = 2 * std::numbers::pi / symmetry_order;
  return std::abs(std::remainder(yaw, period)) <= tolerance.yaw;
}

Truth SeatedTruth(const Eigen::Isometry3d& X_SO, int symmetry_order,
                  const SeatTolerance& tolerance,
                  const PoseUncertainty& uncertainty) {
  const auto with_margin = [&](double sign) {
    return SeatTolerance{tolerance.z + sign * uncertainty.position,
                         tolerance.xy + sign * uncertainty.position,
                         tolerance.tilt + sign * uncertainty.rotation,
                         tolerance.yaw + sign * uncertainty.rotation};
  };
  if (IsSeated(X_SO, symmetry_order, with_margin(-1))) return Truth::kTrue;
  return IsSeated(X_SO, symmetry_order, with_margin(1)) ? Truth::kUnknown
                                                        : Truth::kFalse;
}

double VisibleAngle(const Eigen::Isometry3d& X_AB, int symmetry_order) {
  if (symmetry_order == 0) return AngleOfAxes(X_AB);
  const Eigen::Quaterniond q_AB(X_AB.linear());
  double angle = std::numbers::pi;
  for (int i = 0; i < symmetry_order; ++i) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(
        2 * std::numbers::pi * i / symmetry_order, Eigen::Vector3d::UnitZ()));
    angle = std::min(angle, turn.angularDistance(q_AB));
  }
  return angle;
}

double TiltOf(const Eigen::Isometry3d& X_WO) {
  const Eigen::Vector3d z = X_WO.linear().col(2);
  return std::atan2(z.head<2>().norm(), std::abs(z.z()));
}

}  // namespace cell
