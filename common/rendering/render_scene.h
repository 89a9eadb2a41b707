#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/rendering/body.h"

namespace cell {

/// Bodies, prepared once for rays from any camera at any poses.
class RenderScene {
 public:
  /// @throws std::invalid_argument for duplicate names and for a body without
  /// triangles; std::runtime_error if the ray tracer cannot be had.
  explicit RenderScene(std::vector<RenderBody> bodies);
  ~RenderScene();

  const std::vector<RenderBody>& bodies() const { return bodies_; }

  /// The bodies at their poses in a camera's frame.
  class Posed;
  /// A body that is not in the map is at its fixed pose, or absent if it has
  /// none. Unknown names are ignored.
  std::shared_ptr<const Posed> Pose(
      const std::map<std::string, Eigen::Isometry3d>& X_WO,
      const Eigen::Isometry3d& X_WC) const;

 private:
  struct Tracer;

  std::vector<RenderBody> bodies_;
  std::shared_ptr<Tracer> tracer_;
};

}  // namespace cell
