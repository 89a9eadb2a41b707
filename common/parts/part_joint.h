#pragma once

#include <Eigen/Geometry>
#include <string>

#include "common/config/config.h"

namespace cell {

/// How an articulated part moves: on a hinge or a slide of a fixed part. Its
/// position is 0 where the part stands at first, the lower limit where it is
/// shut or pushed in, the upper one where it is open or pulled out. SI units:
/// positions in rad of a hinge, in m of a slide.
struct PartJoint {
  enum class Kind { kHinge, kSlide };
  Kind kind = Kind::kHinge;
  std::string host;  ///< the fixed part that carries it
  Eigen::Isometry3d X_HO_zero = Eigen::Isometry3d::Identity();
  /// Unit, in O: it turns about it, right-handed, or slides along it.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d p_OA = Eigen::Vector3d::Zero();  ///< on a hinge's axis
  double lower = 0, upper = 0;  ///< limits; 0 lies between them
  double friction = 0;          ///< Coulomb's [N m] or [N]
  double damping = 0;           ///< [N m s/rad] or [N s/m]

  /// Reads the block `joint` of a part; lengths in mm, angles in degrees:
  ///   {on: part, xyz, rpy, kind: hinge, axis: [x,y,z], at: [x,y,z],
  ///    limits_deg: [lower, upper], friction, damping}
  ///   {on: part, xyz, rpy, kind: slide, axis: [x,y,z],
  ///    limits_mm: [lower, upper], friction, damping}
  /// where xyz and rpy are the pose in the host's frame at position 0.
  /// @throws ConfigError naming file:key for another kind, missing limits and
  /// such that do not rise or leave out 0.
  static PartJoint FromConfig(const Config& config);

  /// How the part has moved from position 0, in O.
  Eigen::Isometry3d Displacement(double position) const;
  /// [m] that a point of the part, in O, moves per unit of the position.
  double LeverAt(const Eigen::Vector3d& p_O) const;
};

}  // namespace cell
