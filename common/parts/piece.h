#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace cell {

/// A convex piece of a part, in the part's frame O. SI units.
struct Piece {
  enum class Kind { kBox, kCylinder, kHull };
  Kind kind = Kind::kBox;
  Eigen::Isometry3d X_OP = Eigen::Isometry3d::Identity();  ///< box, cylinder
  Eigen::Vector3d half_extents = Eigen::Vector3d::Zero();  ///< of a box [m]
  double radius = 0;                                       ///< of a cylinder
  double half_length = 0;                 ///< of a cylinder, along its z [m]
  std::vector<Eigen::Vector3d> vertices;  ///< of a hull, in O [m]
  /// Of a hull: vertex indices, counter-clockwise seen from outside.
  std::vector<std::vector<int>> faces;
  std::string contact_class;  ///< of the physics; empty: none
  bool is_shape = true;       ///< counts for rendering and distances
};

/// The piece as a hull in O; a cylinder becomes the prism over the regular
/// `num_sides`-gon inscribed in its circle.
Piece AsHull(const Piece& piece, int num_sides = 24);

/// Prism over a convex outline that runs counter-clockwise, from z_low to
/// z_high of O.
Piece MakePrism(const std::vector<Eigen::Vector2d>& outline, double z_low,
                double z_high);

/// The piece mirrored at the plane x = 0 of O.
Piece MirroredInX(const Piece& piece);

/// Mass, centre and inertia of a body of density 1.
struct VolumeMoments {
  double volume = 0;                                  ///< [m^3]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   ///< in O [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about it [m^5]
};

/// Of the union of pieces that do not overlap; those that are no shape do not
/// count.
VolumeMoments MomentsOf(const std::vector<Piece>& pieces);

/// Why the hull is no convex body with a volume; empty if it is one.
std::string WhyNotConvex(const Piece& hull);

}  // namespace cell
