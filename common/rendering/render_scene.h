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

  /// The bodies where they stand in a camera's frame.
  class Posed;
  /// Bodies of which the map says nothing stand where they always do, or are
  /// not there. Names that are no body's are passed over.
  std::shared_ptr<const Posed> Pose(
      const std::map<std::string, Eigen::Isometry3d>& X_WO,
      const Eigen::Isometry3d& X_WC) const;

 private:
  struct Tracer;

  std::vector<RenderBody> bodies_;
  std::shared_ptr<Tracer> tracer_;
};

}  // namespace cell
