#pragma once

#include <vector>

#include "common/config/config.h"
#include "common/parts/piece.h"

namespace cell {

/// The convex pieces that one entry of a part's `pieces` stands for. Lengths
/// in mm, angles in degrees; every entry may have
///   contact: class of the physics       shape: false  (physics only)
///   mirror_x: true  (once more at -x)
/// and has one of the kinds
///   box          {center: [x,y,z], size: [x,y,z], yaw}
///   cylinder     {center: [x,y,z], axis: x|y|z, radius, length}
///   prism        {outline: [[x,y]...] counter-clockwise, z: [low, high]}
///   hole         {center: [x,y], z, apothem, sides, outer | corner, rotation,
///                 chamfer: [low, high]}: the square block of apothem `outer`
///                 (or whose corners lie on the radius `corner`) around a hole
///                 of `sides` flat sides, one wedge per side; 4 or a multiple
///                 of 8, so that no wedge holds a corner
///   ring_sector  {center: [x,y], z, radii: [in, out], angles: [from, to],
///                 segments}
///   disc_segment {center: [x,y], z, radius, angles: [from, to], segments}:
///                 between arc and chord
/// @throws ConfigError if a piece is not convex or has no volume.
std::vector<Piece> PiecesFromConfig(const Config& config);

/// Reads xyz [mm] and, unless left out, roll, pitch, yaw [deg] about the fixed
/// axes.
Eigen::Isometry3d PoseInMm(const Config& config);

inline constexpr double kMm = 1e-3;
inline constexpr double kMaxLength = 10'000;  // [mm]

}  // namespace cell
