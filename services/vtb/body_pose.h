#pragma once

#include <Eigen/Geometry>
#include <string>

namespace cell::vtb {

/// A body of the world and where it is.
struct BodyPose {
  std::string name;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
};

}  // namespace cell::vtb
