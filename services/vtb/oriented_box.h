#pragma once

#include <Eigen/Geometry>

namespace cell::vtb {

/// A box with its centre and axes at X_AB in a frame A.
struct OrientedBox {
  Eigen::Isometry3d X_AB = Eigen::Isometry3d::Identity();
  Eigen::Vector3d half_extents = Eigen::Vector3d::Zero();  ///< [m]

  /// [m] Of the farthest corner from A's origin, or more.
  double Reach() const {
    return X_AB.translation().norm() + half_extents.norm();
  }
};

/// True if `b`, with its frame A at X_AC of the frame of `a`, may be within
/// `distance` [m] of it. Never false for boxes that are; sometimes true for
/// boxes that are further apart, since only the face normals of both are tried
/// as separating axes.
bool MayBeWithin(const OrientedBox& a, const OrientedBox& b,
                 const Eigen::Isometry3d& X_AC, double distance);

}  // namespace cell::vtb
