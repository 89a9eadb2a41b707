#pragma once

#include <string>
#include <utility>
#include <vector>

#include "common/geometry/truth_poses.h"
#include "common/imaging/rgbd_frame.h"
#include "common/rendering/render_scene.h"

namespace cell::camera_set {

/// The pictures that an ideal RGB-D camera takes of the world: depth right to
/// half a count, no noise.
class RenderedView {
 public:
  struct Params {
    std::string camera = "1";
    Camera view;
    double depth_unit = 1e-4;  ///< [m] 0.1 mm: sees 6.5 m far
    bool has_shadows = false;
    int num_threads = 1;  ///< 0: one a core
  };

  RenderedView(std::vector<RenderBody> bodies, Params params)
      : scene_(std::move(bodies)), params_(std::move(params)) {}

  RgbdFrame Capture(const TruthPoses& truth) const;

 private:
  RenderScene scene_;
  Params params_;
};

/// Counts of `unit` [m]; 0 for what is further away than they reach.
DepthImage DepthInCounts(const std::vector<float>& depth, int width, int height,
                         double unit);

}  // namespace cell::camera_set
