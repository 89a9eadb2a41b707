#pragma once

#include <filesystem>

#include "common/imaging/depth_image.h"
#include "common/imaging/rgb_image.h"

namespace cell::camera_set {

/// An organised cloud as pictures.
struct PcdImage {
  RgbImage colour;
  DepthImage depth;
  /// Finite points that have become no depth.
  struct Lost {
    int num_beyond = 0;  ///< farther than `range`
    int num_behind = 0;  ///< at the camera or behind it
    double range = 0;    ///< [m]
  };
  Lost lost;
};

/// Reads a PCD file (ascii, binary or compressed) with points x, y, z [m] in
/// the camera's frame, one for each pixel, and their colour, rgb or rgba. Depth
/// is z in counts of `depth_unit` [m]; 0 for points that are not finite.
/// @throws std::runtime_error naming the file if it is missing, if CheckPcd()
/// refuses it, or if all points are too far: probably in another unit.
PcdImage ReadPcd(const std::filesystem::path& path, double depth_unit);

}  // namespace cell::camera_set
