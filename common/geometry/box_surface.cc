#include "common/geometry/box_surface.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace cell {

std::vector<Eigen::Vector3d> SampleBoxSurface(
    const Eigen::Vector3d& half_extents, double spacing) {
  if (!(spacing > 0)) {
    throw std::invalid_argument("spacing " + std::to_string(spacing) + " m");
  }
  std::array<int, 3> num_steps;
  for (size_t axis = 0; axis < 3; ++axis) {
    const double length = 2 * half_extents[static_cast<int>(axis)];
    num_steps[axis] = static_cast<int>(std::ceil(length / spacing));
  }
  const auto is_end = [&](size_t axis, int step) {
    return step == 0 || step == num_steps[axis];
  };
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= num_steps[0]; ++i) {
    for (int j = 0; j <= num_steps[1]; ++j) {
      for (int k = 0; k <= num_steps[2]; ++k) {
        if (!is_end(0, i) && !is_end(1, j) && !is_end(2, k)) continue;
        const Eigen::Array3d fraction(double(i) / num_steps[0],
                                      double(j) / num_steps[1],
                                      double(k) / num_steps[2]);
        points.push_back(half_extents.array() * (2 * fraction - 1));
      }
    }
  }
  return points;
}

}  // namespace cell
