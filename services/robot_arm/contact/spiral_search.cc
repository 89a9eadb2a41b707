#include "services/robot_arm/contact/spiral_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cell::robot_arm {

using Eigen::Vector2d;

void SpiralSearch::Begin(double height) {
  if (is_searching()) return;
  angle_ = radius_ = 0;
  is_returning_ = false;
  height_ = height;
  ++num_spirals_;
}

SpiralSearch::State SpiralSearch::Step(double height, double dt) {
  if (!is_searching()) return State::kIdle;
  if (height < height_ - params_.found) {
    middle_ += Circle();
    angle_ = -1;
    return State::kFound;
  }
  GoOn(params_.speed * dt);
  return num_spirals_ > params_.max_spirals ? State::kExhausted
                                            : State::kSearching;
}

/// Outwards, then straight back to the middle: an arm cannot jump there.
void SpiralSearch::GoOn(double way) {
  if (is_returning_) {
    radius_ = std::max(0.0, radius_ - way);
    is_returning_ = radius_ > 0;
    if (!is_returning_) angle_ = 0;
  } else if (radius_ < params_.radius) {
    angle_ += way / std::max(radius_, params_.pitch / 2);
    radius_ = params_.pitch * angle_ / (2 * std::numbers::pi);
  } else {
    is_returning_ = true;
    ++num_spirals_;
  }
}

Vector2d SpiralSearch::Circle() const {
  if (!is_searching()) return Vector2d::Zero();
  return radius_ * Vector2d(std::cos(angle_), std::sin(angle_));
}

}  // namespace cell::robot_arm
