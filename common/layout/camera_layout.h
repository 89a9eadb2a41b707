#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "common/config/config.h"

namespace cell {

/// Where the camera sets look from: on a circle about what they look at, at one
/// elevation. cell.yaml's `cameras`. Frames C1..Cn: z ahead, x right, y down.
struct CameraLayout {
  Eigen::Vector3d p_W_look_at = Eigen::Vector3d::Zero();
  double distance = 0;                                    ///< [m]
  double elevation = 0;                                   ///< [rad]
  std::vector<double> azimuths;                           ///< [rad] from x of W
  Eigen::Vector2d view_angles = Eigen::Vector2d::Zero();  ///< [rad] wide, high

  /// @throws ConfigError naming file:key.
  static CameraLayout FromConfig(const Config& config);

  /// X_WC of each set.
  std::vector<Eigen::Isometry3d> Poses() const;
  /// True if a set at X_WC has the point in its field of view.
  bool IsInView(const Eigen::Isometry3d& X_WC,
                const Eigen::Vector3d& p_W) const;
};

}  // namespace cell
