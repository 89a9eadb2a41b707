#include "services/vtb/arm_servo.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace cell::vtb {

ArmServo::ArmServo(const Params& params, const Joints& max_speed,
                   const Joints& q)
    : params_(params),
      max_speed_(max_speed),
      // |H(jw)| = omega^2 / (omega^2 + w^2) is 1/sqrt(2) at the bandwidth.
      omega_(2 * std::numbers::pi * params.bandwidth /
             std::sqrt(std::numbers::sqrt2 - 1)),
      q_(q),
      goal_(q) {}

void ArmServo::Command(const Joints& q, bool clear_stop) {
  if (state_ == State::kStopped && !clear_stop) return;
  state_ = State::kFollowing;
  num_silent_ = 0;
  command_ = q;
}

void ArmServo::Stop() {
  StopAt(params_.stop_force + 1);
}

void ArmServo::StopAt(double force) {
  if (state_ == State::kStopped) return;
  state_ = State::kStopped;
  stopped_by_ = force;
  goal_ = q_;
  command_.reset();
  delayed_.clear();
}

void ArmServo::Update(double dt, double force) {
  if (force > params_.stop_force) StopAt(force);
  if (!command_ && state_ == State::kFollowing &&
      ++num_silent_ > params_.patience_ticks) {
    state_ = State::kHolding;
  }
  delayed_.push_back(std::exchange(command_, std::nullopt));
  if (delayed_.size() > static_cast<size_t>(params_.dead_ticks)) {
    if (delayed_.front()) goal_ = *delayed_.front();
    delayed_.pop_front();
  }
  MoveTowards(dt);
}

/// The exact motion of the double pole towards a goal that stays for `dt`.
void ArmServo::MoveTowards(double dt) {
  const double decay = std::exp(-omega_ * dt);
  for (int i = 0; i < q_.size(); ++i) {
    const double max_speed = max_speed_[i];
    const double error = q_[i] - goal_[i];
    const double rise = v_[i] + omega_ * error;
    double next = goal_[i] + (error + rise * dt) * decay;
    double speed = (v_[i] - omega_ * rise * dt) * decay;
    const double reach = max_speed * dt;
    if (std::abs(next - q_[i]) > reach) {
      next = q_[i] + std::copysign(reach, next - q_[i]);
      speed = std::copysign(max_speed, next - q_[i]);
    }
    v_[i] = std::clamp(speed, -max_speed, max_speed);
    q_[i] = next;
  }
}

}  // namespace cell::vtb
