#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "cell/truth_poses_t.hpp"
#include "common/config/deployment.h"
#include "common/imaging/rgb_image.h"
#include "common/task/task.h"

namespace cell::cli {

/// From where and how a picture of the cell is taken, and what fills it.
struct Viewpoint {
  double azimuth_deg = -90;   ///< of the camera about z of W, from x
  double elevation_deg = 38;  ///< above the table
  /// "cell": all but the table; "parts": the task's parts; or the name of a
  /// body, or of what has several bodies: "arm_left".
  std::string focus = "cell";
  int width = 1280;
  int height = 960;
  bool is_of_ids = false;   ///< give every body its own colour
  bool has_labels = false;  ///< each part that is seen has its name on it
};

/// A picture of the cell, and the pixels that each body covers.
struct ScenePicture {
  RgbImage image;
  std::map<std::string, int> num_pixels;
};

/// The cell as TRUTH_POSES has it.
/// @throws std::invalid_argument for a focus that is not there.
ScenePicture PictureOf(const Task& task, const truth_poses_t& poses,
                       const Viewpoint& viewpoint);

/// Draws the cell as TRUTH_POSES has it into a PNG file.
/// @return pixels that each body covers.
/// @throws ConfigError for the task's files, std::invalid_argument for a focus
/// that is not there, std::runtime_error for the file.
std::map<std::string, int> DrawScene(const Deployment& deployment,
                                     const truth_poses_t& poses,
                                     const Viewpoint& viewpoint,
                                     const std::filesystem::path& path);

}  // namespace cell::cli
