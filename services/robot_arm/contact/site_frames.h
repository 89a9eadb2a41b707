#pragma once

#include <Eigen/Geometry>

namespace cell::robot_arm {

/// Frames of a part in a gripper on its way to a site.
struct SiteFrames {
  Eigen::Isometry3d X_WS = Eigen::Isometry3d::Identity();  ///< of the site
  Eigen::Isometry3d X_GO = Eigen::Isometry3d::Identity();  ///< of the part
  /// The rotation about z of S that the part is seated with.
  Eigen::Isometry3d X_symmetry = Eigen::Isometry3d::Identity();

  /// Where the gripper is when the part is at X_SO, turned so.
  Eigen::Isometry3d GripperAt(const Eigen::Isometry3d& X_SO) const;
  /// The inverse: X_SO of the part when the gripper is at X_WG.
  Eigen::Isometry3d PartAt(const Eigen::Isometry3d& X_WG) const;
  /// Height of the part's origin over the site.
  double HeightAt(const Eigen::Isometry3d& X_WG) const;
};

}  // namespace cell::robot_arm
