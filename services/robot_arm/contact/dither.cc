#include "services/robot_arm/contact/dither.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cell::robot_arm {

void Dither::Step(bool is_wanted, double dt) {
  const double step = dt / params_.rise_time;
  share_ = std::clamp(share_ + (is_wanted ? step : -step), 0.0, 1.0);
}

Eigen::Vector3d Dither::Turn(double time) const {
  const double phase = 2 * std::numbers::pi * time;
  const double tilt = share_ * params_.tilt;
  return {tilt * std::sin(phase / params_.tilt_period),
          tilt * std::cos(phase / params_.tilt_period),
          share_ * params_.yaw * std::sin(phase / params_.yaw_period)};
}

}  // namespace cell::robot_arm
