#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>

#include "cell/truth_poses_t.hpp"
#include "common/config/deployment.h"

namespace cell::cli {

/// From where and how a picture of the cell is taken.
struct Viewpoint {
  double azimuth_deg = -62;   ///< of the camera about z of W, from x
  double elevation_deg = 38;  ///< above the table
  double distance = 1.75;     ///< [m] from what it looks at
  std::array<double, 3> target = {0.03, -0.12, 0.10};  ///< [m] in W
  int width = 1280;
  int height = 960;
  bool is_of_ids = false;  ///< every body in a colour of its own
};

/// Draws the cell as TRUTH_POSES has it into a PNG file.
/// @return pixels that each body covers.
/// @throws ConfigError for the task's files, std::runtime_error for the file.
std::map<std::string, int> DrawScene(const Deployment& deployment,
                                     const truth_poses_t& poses,
                                     const Viewpoint& viewpoint,
                                     const std::filesystem::path& path);

}  // namespace cell::cli
