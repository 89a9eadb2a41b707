#include "services/robot_arm/contact/stall_detector.h"

#include <cmath>

namespace cell::robot_arm {

void StallDetector::Step(double force, double push, double height, double dt) {
  const bool is_pushing = force > params_.push_share * push;
  if (!is_pushing || std::abs(height - height_) > params_.move) {
    stall_time_ = 0;
    height_ = height;
    return;
  }
  stall_time_ += dt;
}

}  // namespace cell::robot_arm
