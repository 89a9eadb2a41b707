#include "common/layout/vectors.h"

#include <numbers>
#include <vector>

namespace cell {

Eigen::Vector2d Vector2(const Config& config, const std::string& key) {
  const std::vector<double> v = config.Numbers(key, 2);
  return {v[0], v[1]};
}

Eigen::Vector3d Vector3(const Config& config, const std::string& key) {
  const std::vector<double> v = config.Numbers(key, 3);
  return {v[0], v[1], v[2]};
}

Eigen::Isometry3d PoseFromConfig(const Config& config) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = Vector3(config, "xyz");
  if (config.Has("rpy_deg")) {
    const Eigen::Vector3d rpy =
        Vector3(config, "rpy_deg") * std::numbers::pi / 180;
    X.linear() = (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                  Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
                     .toRotationMatrix();
  }
  return X;
}

}  // namespace cell
