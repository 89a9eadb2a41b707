#include "services/robot_arm/contact/slow_down.h"

#include <algorithm>

namespace cell::robot_arm {

double SlowDown::Rate(const Eigen::Vector2d& sideways) const {
  return 1 / (1 + params_.gain * std::max(0.0, sideways.norm() - params_.dead));
}

}  // namespace cell::robot_arm
