#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "common/config/config.h"

namespace cell {

/// Where things stand in the cell: cell.yaml of a task. Frame W: z = 0 is the
/// table top, x right, y away from the person. SI units.
struct CellLayout {
  /// Box that carries the part which is fixed: that part's frame stands on the
  /// middle of its top.
  struct Pedestal {
    Eigen::Vector2d size = Eigen::Vector2d::Zero();
    double height = 0;
    Eigen::Isometry3d X_WP = Eigen::Isometry3d::Identity();  ///< of its top
  };
  struct PartsArea {
    Eigen::Vector2d centre = Eigen::Vector2d::Zero();
    Eigen::Vector2d size = Eigen::Vector2d::Zero();
  };
  /// A hand is three boxes "<hand>.palm", "<hand>.thumb", "<hand>.fingers",
  /// upright in its frame G (Grasp).
  struct HandBox {
    Eigen::Vector3d half_extents = Eigen::Vector3d::Zero();
    double z = 0;  ///< of its centre in G
  };
  struct Hand {
    std::string name;
    Eigen::Vector3d p_WG_rest = Eigen::Vector3d::Zero();  ///< fingers down
  };

  /// @throws ConfigError naming file:key.
  static CellLayout FromConfig(const Config& config);

  /// Parts outside are out of the cell's reach.
  Eigen::AlignedBox3d workspace;
  Pedestal pedestal;
  PartsArea parts_area;
  HandBox palm;
  HandBox thumb;    ///< its inner face at -x
  HandBox fingers;  ///< their inner face at +x
  std::vector<Hand> hands;
};

}  // namespace cell
