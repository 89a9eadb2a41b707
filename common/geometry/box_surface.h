#pragma once

#include <Eigen/Core>
#include <vector>

namespace cell {

/// Points on the surface of a box about the origin, its corners among them, on
/// grids of at most `spacing`; no point twice. [m]
/// @throws std::invalid_argument unless spacing > 0.
std::vector<Eigen::Vector3d> SampleBoxSurface(
    const Eigen::Vector3d& half_extents, double spacing);

}  // namespace cell
