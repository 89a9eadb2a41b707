#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "common/config/config.h"

namespace cell {

/// The shape of a hand - a person's, or a gripper's - as boxes in its frame G
/// (Grasp): fingers close along x onto the origin, the hand approaches along
/// -z. A box is called "<hand>.<box>" wherever bodies are named.
struct HandType {
  struct Box {
    std::string name;
    Eigen::Vector3d half_extents = Eigen::Vector3d::Zero();
  };
  /// Where a box is in one way of gripping: at X_GB + slide * opening / 2.
  struct BoxPlace {
    Eigen::Isometry3d X_GB = Eigen::Isometry3d::Identity();  ///< closed
    Eigen::Vector3d slide = Eigen::Vector3d::Zero();
  };
  /// One way to place the fingers, e.g. two against each other.
  struct Grip {
    std::string name;
    std::vector<BoxPlace> places;  ///< in the order of the boxes
  };

  std::string name;
  std::vector<Box> boxes;
  std::vector<Grip> grips;
  double max_opening = 0;  ///< [m]

  /// The boxes that move in some grip.
  std::vector<Box> Fingers() const;
  /// Nothing if it cannot grip so.
  const Grip* FindGrip(const std::string& grip) const;
  /// X_GB of box `index` at an opening [m].
  static Eigen::Isometry3d PlaceOf(const Grip& grip, size_t index,
                                   double opening);
  /// True for boxes that move when the hand opens: what grips.
  static bool IsFinger(const BoxPlace& place);
};

/// The map `hand_types` of cell.yaml. @throws ConfigError naming file:key.
std::map<std::string, HandType> HandTypesFromConfig(const Config& config);

}  // namespace cell
