#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/imaging/camera.h"

namespace cell {

/// From where and how wide a picture is taken.
struct PictureShape {
  double azimuth_rad = 0;    ///< of the camera about z of W, from x
  double elevation_rad = 0;  ///< above the plane z = 0, below a right angle
  int width = 1280;
  int height = 960;
  double horizontal_view_rad = 0.87;
  /// Left free at each edge, as a part of the width or height; below 0.5.
  double margin = 0.03;
};

/// The nearest camera from that direction that sees all of the points.
/// @param p_WP  [m] at least one
/// @throws std::invalid_argument for no points, sizes or angles that are not
/// positive, or a view straight down.
Camera CameraThatFrames(const std::vector<Eigen::Vector3d>& p_WP,
                        const PictureShape& shape);

}  // namespace cell
