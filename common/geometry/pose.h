#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "cell/pose_t.hpp"

namespace cell {

/// The pose X_WF in a message. Nothing if a number is not finite, if the
/// position lies beyond 100 m, or if the quaternion is not of unit length to
/// 1e-4; within that it is normalised.
std::optional<Eigen::Isometry3d> PoseFromMessage(const pose_t& message);

/// The quaternion is unit, with w >= 0.
pose_t PoseToMessage(const Eigen::Isometry3d& X_WF);

/// [rad] Angle of the rotation that takes one frame's axes to the other's.
double AngleBetween(const Eigen::Isometry3d& X_WA,
                    const Eigen::Isometry3d& X_WB);

}  // namespace cell
