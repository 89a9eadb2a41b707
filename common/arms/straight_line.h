#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "common/layout/arm_layout.h"
#include "common/result/result.h"

namespace cell {

/// The pose at `share` of the way from A to B: straight, turning evenly.
Eigen::Isometry3d PoseBetween(const Eigen::Isometry3d& X_WA,
                              const Eigen::Isometry3d& X_WB, double share);

/// The joints that bring the gripper to X_WG and are nearest to `seed`, in its
/// configuration. Nothing if there are none within the limits.
std::optional<Joints> TrackPose(const ArmLayout& arm,
                                const Eigen::Isometry3d& X_WG,
                                const Joints& seed);

/// The joints that have the gripper `height` [m] above where `q` has it, in the
/// same configuration: what a path over obstacles may pass. Nothing if out of
/// reach.
std::optional<Joints> RaisedBy(double height, const ArmLayout& arm,
                               const Joints& q);

/// A motion of the gripper along a straight line, from the first joints on, or
/// why it cannot be.
using StraightLine = Result<std::vector<Joints>>;

struct StraightLineParams {
  double step = 0.010;         ///< [m] and, times 10, [rad] of the gripper
  double max_jump = 0.35;      ///< [rad] of any joint in a step
  double joint_margin = 0.05;  ///< [rad] kept from the limits
};

/// From where `start` has the gripper to X_WG, in the configuration of `start`:
/// each step within the joint limits, away from singularities and without a
/// jump. Collisions are not looked at.
StraightLine TrackLine(const ArmLayout& arm, const Joints& start,
                       const Eigen::Isometry3d& X_WG,
                       const StraightLineParams& params = {});

}  // namespace cell
