#include "services/vtb/oriented_box.h"

namespace cell::vtb {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

bool MayBeWithin(const OrientedBox& a, const OrientedBox& b,
                 const Isometry3d& X_AC, double distance) {
  const Matrix3d R_aA = a.X_AB.linear().transpose();
  const Vector3d p =
      R_aA * (X_AC * b.X_AB.translation() - a.X_AB.translation());
  const Matrix3d R = R_aA * X_AC.linear() * b.X_AB.linear();
  const Matrix3d extent = R.cwiseAbs();
  const Vector3d gap_a =
      p.cwiseAbs() - a.half_extents - extent * b.half_extents;
  if (gap_a.maxCoeff() > distance) return false;
  const Vector3d gap_b = (R.transpose() * p).cwiseAbs() - b.half_extents -
                         extent.transpose() * a.half_extents;
  return gap_b.maxCoeff() <= distance;
}

}  // namespace cell::vtb
