#include "common/kinematics/arm_model.h"

#include <cmath>
#include <numbers>

namespace cell {

Eigen::Isometry3d ArmModel::FlangePose(const Joints& q) const {
  return LinkPoses(q).back();
}

std::optional<Joints> ArmModel::SolveNear(const Eigen::Isometry3d& X_BF,
                                          const Joints& seed) const {
  const IkConfiguration configuration = ConfigurationOf(seed);
  for (const Joints& q : SolveInverse(X_BF, seed)) {
    if (ConfigurationOf(q) != configuration) continue;
    const Joints near = NearestTo(seed, q);
    if (IsWithinLimits(near)) return near;
  }
  return std::nullopt;
}

Joints ArmModel::NearestTo(const Joints& seed, const Joints& q) const {
  constexpr double kTurn = 2 * std::numbers::pi;
  Joints nearest = q;
  for (int i = 0; i < kNumJoints; ++i) {
    double& angle = nearest[i];
    const double limit = limits().angle[i];
    angle += kTurn * std::round((seed[i] - angle) / kTurn);
    if (angle > limit) angle -= kTurn;
    if (angle < -limit) angle += kTurn;
  }
  return nearest;
}

double ArmModel::LimitMargin(const Joints& q) const {
  return (limits().angle - q.cwiseAbs()).minCoeff();
}

bool ArmModel::IsWithinLimits(const Joints& q) const {
  return (q.cwiseAbs().array() <= limits().angle.array()).all();
}

}  // namespace cell
