#include "services/camera_set/rendered_view.h"

#include <limits>
#include <utility>

#include "common/rendering/renderer.h"

namespace cell::camera_set {

RgbdFrame RenderedView::Capture(const TruthPoses& truth) const {
  RenderParams rendering;
  rendering.has_shadows = params_.has_shadows;
  rendering.num_threads = params_.num_threads;
  const Camera& view = params_.view;
  RenderImage image = Render(scene_, truth.poses, view, rendering);
  return {
      truth.utime,
      params_.camera,
      view,
      params_.depth_unit,
      std::move(image.colour),
      DepthInCounts(image.depth, view.width, view.height, params_.depth_unit)};
}

DepthImage DepthInCounts(const std::vector<float>& depth, int width, int height,
                         double unit) {
  constexpr float kMost = std::numeric_limits<uint16_t>::max();
  const auto per_metre = static_cast<float>(1 / unit);
  DepthImage image{width, height, {}};
  image.counts.reserve(depth.size());
  for (const float z : depth) {
    const float count = z * per_metre + 0.5F;
    image.counts.push_back(count < kMost ? static_cast<uint16_t>(count) : 0);
  }
  return image;
}

}  // namespace cell::camera_set
