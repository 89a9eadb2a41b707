#pragma once

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "common/rendering/render_scene.h"

namespace cell {

struct DeviceDeleter {
  void operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }
};
struct SceneDeleter {
  void operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }
};
using DevicePtr = std::unique_ptr<RTCDeviceTy, DeviceDeleter>;
using ScenePtr = std::unique_ptr<RTCSceneTy, SceneDeleter>;

/// One scene of the ray tracer per body, in its frame O.
struct RenderScene::Tracer {
  DevicePtr device;
  std::vector<ScenePtr> bodies;
};

class RenderScene::Posed {
 public:
  /// Instances of bodies in the camera's frame C; the id of an instance is the
  /// body's index.
  ScenePtr scene;
  /// Of each body; meaningless for those that are not there.
  std::vector<Eigen::Isometry3f> X_CO;
  std::shared_ptr<const Tracer> tracer;
};

}  // namespace cell
