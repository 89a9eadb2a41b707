#include "services/robot_arm/aim_error.h"

#include <cmath>
#include <random>

namespace cell::robot_arm {

Eigen::Isometry3d AimError::Of(int64_t request) const {
  if (offset == 0 && angle == 0) return Eigen::Isometry3d::Identity();
  std::seed_seq seeds = {static_cast<uint32_t>(seed >> 32),
                         static_cast<uint32_t>(seed),
                         static_cast<uint32_t>(request)};
  std::mt19937_64 random(seeds);
  std::normal_distribution<double> normal;
  const auto next = [&](double rms, int num_axes) {
    return rms / std::sqrt(num_axes) * normal(random);
  };
  Eigen::Isometry3d X_SE = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 2; ++i) X_SE.translation()[i] = next(offset, 2);
  Eigen::Vector3d turn;
  for (int i = 0; i < 3; ++i) turn[i] = next(angle, 3);
  if (const double by = turn.norm(); by > 0) {
    X_SE.linear() = Eigen::AngleAxisd(by, turn / by).toRotationMatrix();
  }
  return X_SE;
}

}  // namespace cell::robot_arm
