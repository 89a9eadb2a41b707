#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

#include "common/config/config.h"

namespace cell {

/// A convex piece of a part, in the part's frame O. SI units.
struct Piece {
  enum class Kind { kBox, kCylinder, kHull };
  Kind kind = Kind::kBox;
  Eigen::Isometry3d X_OP = Eigen::Isometry3d::Identity();  ///< box, cylinder
  Eigen::Vector3d half_extents = Eigen::Vector3d::Zero();  ///< of a box [m]
  double radius = 0;                                       ///< of a cylinder
  double half_length = 0;  ///< of a cylinder, along its z [m]
  std::vector<Eigen::Vector3d> vertices;  ///< of a hull, in O [m]
  /// Of a hull: vertex indices, counter-clockwise seen from outside.
  std::vector<std::vector<int>> faces;
  std::string contact_class;  ///< of the physics; empty: none
  bool is_shape = true;       ///< counts for rendering and distances
};

/// Where a part belongs on another one: the frame S that the part's frame O
/// coincides with when it is seated. It is inserted along -z of S.
struct Site {
  std::string name;  ///< "<part>.<site>"
  std::string type;  ///< what may go there, e.g. a kind of hole
  std::string host;  ///< part
  Eigen::Isometry3d X_HS = Eigen::Isometry3d::Identity();
  double approach = 0;  ///< [m] along z of S, from where the way in is straight
  double opening = 0;   ///< [m] radius of the free column that the way in needs
  double depth = 0;     ///< [m] from the site's mouth to its floor
};

/// How a hand takes a part: gripper frame G (approach along -z, fingers close
/// along x).
struct Grasp {
  Eigen::Isometry3d X_OG = Eigen::Isometry3d::Identity();
  double width = 0;  ///< [m] between the fingers
};

/// One part of a task: a row of parts.yaml.
struct Part {
  std::string name;
  std::string type;               ///< of the task's domain
  std::vector<std::string> fits;  ///< site types it may be seated at
  std::vector<Piece> pieces;
  std::vector<Site> sites;
  std::vector<Grasp> grasps;
  /// Rotations about z of O that leave it as it is: 0 any angle, else n-fold.
  int symmetry_order = 1;
  bool is_fixed = false;  ///< clamped to the pedestal
  double density = 0;     ///< [kg/m^3]
  std::array<double, 3> colour{};  ///< 0..1
};

/// All parts of a task (DESIGN contract 8).
class PartTable {
 public:
  /// @throws ConfigError naming file:key for unknown or missing keys and for
  /// impossible parts (no volume, not convex, unknown type, twin names).
  static PartTable FromConfig(const Config& config);

  const std::vector<Part>& parts() const { return parts_; }
  /// Nothing if there is none of that name.
  const Part* Find(const std::string& name) const;
  const Site* FindSite(const std::string& name) const;
  /// Pairs of contact classes that collide; "table" is the table's.
  const std::vector<std::array<std::string, 2>>& contacts() const {
    return contacts_;
  }

 private:
  std::vector<Part> parts_;
  std::vector<std::array<std::string, 2>> contacts_;
};

/// The piece as a hull in O; a cylinder becomes the prism over the regular
/// `num_sides`-gon inscribed in its circle.
Piece AsHull(const Piece& piece, int num_sides = 24);

}  // namespace cell
