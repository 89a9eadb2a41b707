#include "common/geometry/pose.h"

#include <algorithm>
#include <cmath>

namespace cell {
namespace {

constexpr double kMaxDistance = 100;
constexpr double kUnitTolerance = 1e-4;

}  // namespace

std::optional<Eigen::Isometry3d> PoseFromMessage(const pose_t& message) {
  const Eigen::Vector3d p(message.position);
  const Eigen::Quaterniond q(message.quat_wxyz[0], message.quat_wxyz[1],
                             message.quat_wxyz[2], message.quat_wxyz[3]);
  // Written so that NaN fails.
  if (!(p.cwiseAbs().maxCoeff() <= kMaxDistance) || !p.allFinite() ||
      !q.coeffs().allFinite() || !(std::abs(q.norm() - 1) <= kUnitTolerance)) {
    return std::nullopt;
  }
  return Eigen::Translation3d(p) * q.normalized();
}

pose_t PoseToMessage(const Eigen::Isometry3d& X_WF) {
  Eigen::Quaterniond q(X_WF.linear());
  q.normalize();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  pose_t message{};
  std::copy_n(X_WF.translation().data(), 3, message.position);
  message.quat_wxyz[0] = q.w();
  message.quat_wxyz[1] = q.x();
  message.quat_wxyz[2] = q.y();
  message.quat_wxyz[3] = q.z();
  return message;
}

double AngleBetween(const Eigen::Isometry3d& X_WA,
                    const Eigen::Isometry3d& X_WB) {
  return Eigen::Quaterniond(X_WA.linear())
      .angularDistance(Eigen::Quaterniond(X_WB.linear()));
}

}  // namespace cell
