#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "common/parts/part_table.h"

namespace cell {

/// A convex piece of a part, with what distance queries need at hand. All in
/// the part's frame O, SI units.
class ConvexSolid {
 public:
  explicit ConvexSolid(const Piece& piece);

  const Piece& piece() const { return piece_; }
  const Eigen::AlignedBox3d& box() const { return box_; }
  const Eigen::Vector3d& centre() const { return centre_; }
  /// Of the sphere about centre() that holds the solid.
  double radius() const { return radius_; }

  /// [m] From a point to the solid, 0 inside.
  double DistanceTo(const Eigen::Vector3d& p_O) const;

  /// How far the solid reaches along the unit vector: max n . p over it.
  double Support(const Eigen::Vector3d& n_O) const;

 private:
  struct Face {
    Eigen::Vector3d normal;
    std::vector<Eigen::Vector3d> vertices;  // counter-clockwise from outside
  };
  double DistanceToHull(const Eigen::Vector3d& p_O) const;

  Piece piece_;
  Eigen::Isometry3d X_PO_;
  Eigen::AlignedBox3d box_;
  Eigen::Vector3d centre_;
  double radius_ = 0;
  std::vector<Face> faces_;  // of a hull
};

}  // namespace cell
