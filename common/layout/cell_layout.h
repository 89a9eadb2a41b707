#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "common/config/config.h"
#include "common/layout/arm_layout.h"
#include "common/layout/camera_layout.h"
#include "common/layout/hand_type.h"

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
  /// A person's hand.
  struct Hand {
    std::string name;
    HandType type;
    Eigen::Vector3d p_WG_rest = Eigen::Vector3d::Zero();  ///< fingers down
  };
  /// Any hand: a person's or an arm's gripper.
  struct NamedHand {
    std::string name;
    const HandType* type;
  };

  /// @throws ConfigError naming file:key.
  static CellLayout FromConfig(const Config& config);

  /// Persons' hands, then grippers. Refers to this object.
  std::vector<NamedHand> AllHands() const;
  /// Nothing if there is none of that name.
  const ArmLayout* FindArm(const std::string& name) const;

  /// Parts outside are out of the cell's reach.
  Eigen::AlignedBox3d workspace;
  Pedestal pedestal;
  PartsArea parts_area;
  std::vector<Hand> hands;      ///< persons'
  std::vector<ArmLayout> arms;  ///< by name
  std::optional<CameraLayout> cameras;
};

}  // namespace cell
