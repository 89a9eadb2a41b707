#include "services/robot_arm/yield_policy.h"

namespace cell::robot_arm {
namespace {

constexpr double kFirstPause = 0.2, kSecondPause = 1.0;  // [s]
constexpr double kFree = 1.0;    // [s] then the waiting is over
constexpr double kAround = 2.5;  // [s] of waiting
constexpr double kFirstPatience = 20, kSecondPatience = 6;  // [s] of waiting

}  // namespace

YieldPolicy::Advice YieldPolicy::Step(bool is_blocked, double dt) {
  if (pause_ <= 0 && is_blocked) {
    pause_ = goes_first_ ? kFirstPause : kSecondPause;
  }
  if (pause_ <= 0) {
    free_ += dt;
    if (free_ > kFree) waited_ = tried_ = 0;
    return Advice::kGo;
  }
  pause_ -= dt;
  waited_ += dt;
  free_ = 0;
  if (waited_ > (goes_first_ ? kFirstPatience : kSecondPatience)) {
    pause_ = waited_ = tried_ = 0;
    return Advice::kGiveUp;
  }
  if (waited_ - tried_ < kAround) return Advice::kWait;
  tried_ = waited_;
  return Advice::kGoAround;
}

}  // namespace cell::robot_arm
