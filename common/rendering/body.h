#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/parts/part_table.h"

namespace cell {

/// Something that can be seen: a triangle mesh in its frame O, in one colour.
struct RenderBody {
  std::string name;
  std::array<double, 3> colour = {0.5, 0.5, 0.5};  ///< linear, 0..1
  std::vector<Eigen::Vector3f> vertices;           ///< [m]
  std::vector<std::array<uint32_t, 3>> triangles;
  /// Of a body that does not move.
  std::optional<Eigen::Isometry3d> X_WO;
};

/// The pieces of the part that count for rendering.
RenderBody BodyOf(const Part& part);

/// A box with its middle in O.
RenderBody BoxBody(const std::string& name, const Eigen::Vector3d& half_extents,
                   const std::array<double, 3>& colour);

/// A square of the plane z = 0 of O.
RenderBody PlaneBody(const std::string& name, double half_width,
                     const std::array<double, 3>& colour);

}  // namespace cell
