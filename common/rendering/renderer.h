#pragma once

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <string>

#include "common/imaging/camera.h"
#include "common/rendering/render_image.h"
#include "common/rendering/render_scene.h"

namespace cell {

struct RenderParams {
  /// The colour of a pixel is the mean of this number squared of samples.
  int samples_per_side = 1;
  bool has_shadows = true;
  int num_threads = 1;  ///< 0: one a core; the image is the same for any
  std::array<double, 3> background = {0.70, 0.74, 0.78};  ///< linear
};

/// Renders bodies at their poses under two distant lights (Lambert). Depth and
/// ids are those of the pixels' centres.
RenderImage Render(const RenderScene& scene,
                   const std::map<std::string, Eigen::Isometry3d>& X_WO,
                   const Camera& camera, const RenderParams& params = {});

}  // namespace cell
