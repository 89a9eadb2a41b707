#include "common/arms/straight_line.h"

#include <algorithm>
#include <cmath>

#include "common/arms/arm_bodies.h"

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;

int NumSteps(const Isometry3d& X_WA, const Isometry3d& X_WB, double step) {
  const double way = (X_WB.translation() - X_WA.translation()).norm();
  const double turn =
      Quaterniond(X_WA.linear()).angularDistance(Quaterniond(X_WB.linear()));
  return std::max(
      1, static_cast<int>(std::ceil(std::max(way, turn / 10) / step - 1e-9)));
}

}  // namespace

Isometry3d PoseBetween(const Isometry3d& X_WA, const Isometry3d& X_WB,
                       double share) {
  Isometry3d X = Isometry3d::Identity();
  X.linear() = Quaterniond(X_WA.linear())
                   .slerp(share, Quaterniond(X_WB.linear()))
                   .toRotationMatrix();
  X.translation() =
      (1 - share) * X_WA.translation() + share * X_WB.translation();
  return X;
}

std::optional<Joints> TrackPose(const ArmLayout& arm, const Isometry3d& X_WG,
                                const Joints& seed) {
  return arm.model->SolveNear(FlangePoseFor(arm, X_WG), seed);
}

std::optional<Joints> RaisedBy(double height, const ArmLayout& arm,
                               const Joints& q) {
  return TrackPose(arm,
                   Eigen::Translation3d(0, 0, height) * GripperPose(arm, q), q);
}

StraightLine TrackLine(const ArmLayout& arm, const Joints& start,
                       const Isometry3d& X_WG,
                       const StraightLineParams& params) {
  const Isometry3d X_WG_start = GripperPose(arm, start);
  const int num_steps = NumSteps(X_WG_start, X_WG, params.step);
  if (arm.model->IsNearSingularity(start)) return Reason{"near a singularity"};
  std::vector<Joints> line = {start};
  for (int i = 1; i <= num_steps; ++i) {
    const Joints& last = line.back();
    const auto q = TrackPose(
        arm, PoseBetween(X_WG_start, X_WG, double(i) / num_steps), last);
    if (!q) return Reason{"out of reach"};
    if ((*q - last).cwiseAbs().maxCoeff() > params.max_jump) {
      return Reason{"at a joint limit"};
    }
    if (arm.model->LimitMargin(*q) < params.joint_margin) {
      return Reason{"at a joint limit"};
    }
    if (arm.model->IsNearSingularity(*q)) return Reason{"near a singularity"};
    line.push_back(*q);
  }
  return line;
}

}  // namespace cell
