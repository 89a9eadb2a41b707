#include "services/robot_arm/contact/spiral_search.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cell::robot_arm {

using Eigen::Vector2d;

void SpiralSearch::Begin(double height) {
  if (is_searching()) return;
  angle_ = 0;
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
  const double radius = params_.pitch * angle_ / (2 * std::numbers::pi);
  angle_ += params_.speed * dt / std::max(radius, params_.pitch / 2);
  if (radius < params_.radius) return State::kSearching;
  angle_ = 0;
  return ++num_spirals_ > params_.max_spirals ? State::kExhausted
                                              : State::kSearching;
}

Vector2d SpiralSearch::Circle() const {
  if (!is_searching()) return Vector2d::Zero();
  const double radius = params_.pitch * angle_ / (2 * std::numbers::pi);
  return radius * Vector2d(std::cos(angle_), std::sin(angle_));
}

}  // namespace cell::robot_arm
