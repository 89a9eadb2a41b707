#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "cell/arm_setpoint_t.hpp"
#include "cell/arm_state_t.hpp"
#include "cell/motion_permit_t.hpp"
#include "tests/sim/assembling_cell.h"

namespace cell {

/// Checks the guarantee of the motion chain in every tick of a run:
/// without a permit set-points are frozen within 7 ticks, without set-points
/// the servo stands by itself, and within 25 further ticks the arms rest.
class MotionWatch {
 public:
  static constexpr int32_t kFreezeTicks = 7, kRestTicks = 25;

  explicit MotionWatch(AssemblingCell& cell) : cell_(cell) {
    cell.On<motion_permit_t>("MOTION_PERMIT", [this](const auto& permit) {
      if (permit.hold != motion_permit_t::AT_ONCE)
        permit_tick_ = permit.header.tick;
    });
    for (const char* arm : {"LEFT", "RIGHT"}) {
      const std::string suffix = arm;
      cell.On<arm_setpoint_t>(
          "ARM_SETPOINT_" + suffix,
          [this, suffix](const auto& m) { OnSetpoint(suffix, m); });
      cell.On<arm_state_t>(
          "ARM_STATE_" + suffix,
          [this, suffix](const auto& m) { OnState(suffix, m); });
    }
  }

  /// [ticks] The longest time from the last permit to the last set-point that
  /// moved, and from then on, or from the last set-point of an arm's service,
  /// until the arm rested.
  int32_t max_freeze_ticks() const { return max_freeze_ticks_; }
  int32_t max_rest_ticks() const { return max_rest_ticks_; }
  int num_stops() const { return num_stops_; }

 private:
  static constexpr double kSame = 1e-6;   // [rad], [m]
  static constexpr double kStill = 1e-3;  // [rad/s]
  static constexpr double kThere = 1e-4;  // [rad]
  struct Arm {
    std::optional<arm_setpoint_t> setpoint;
    int32_t moved_tick = -1;  // of the last set-point that was another one
    bool was_moving = false;
    bool is_stopped = false;  // protectively
  };

  void OnSetpoint(const std::string& name, const arm_setpoint_t& setpoint) {
    Arm& arm = arms_[name];
    const int32_t tick = setpoint.header.tick;
    // A restarted service begins where the arm is.
    const bool is_next =
        arm.setpoint && arm.setpoint->header.sender == setpoint.header.sender;
    // After a protective stop they follow the servo, which has no set-point.
    if (is_next && !arm.is_stopped && !IsSame(*arm.setpoint, setpoint)) {
      arm.moved_tick = tick;
      const int32_t without = tick - permit_tick_;
      max_freeze_ticks_ = std::max(max_freeze_ticks_, without);
      EXPECT_LE(without, kFreezeTicks)
          << name << " moves at tick " << tick << " without a permit";
    }
    arm.setpoint = setpoint;
  }

  void OnState(const std::string& name, const arm_state_t& state) {
    Arm& arm = arms_[name];
    const int32_t tick = state.header.tick;
    arm.is_stopped = state.servo == arm_state_t::STOPPED;
    double speed = 0, distance = 0;
    for (size_t i = 0; i < state.position.size(); ++i) {
      speed = std::max(speed, std::abs(state.velocity[i]));
      if (!arm.setpoint) continue;
      distance = std::max(
          distance, std::abs(state.position[i] - arm.setpoint->position[i]));
    }
    const int32_t commanded =
        arm.setpoint ? arm.setpoint->header.tick : permit_tick_;
    // No set-point has come since: the arm stands at the last one.
    const int32_t silent = tick - std::min(permit_tick_, commanded);
    const bool is_moving = speed > kStill;
    if (silent > 1 && is_moving) {
      max_rest_ticks_ = std::max(max_rest_ticks_, silent);
    }
    if (silent > kFreezeTicks + kRestTicks) {
      EXPECT_FALSE(is_moving)
          << name << " at tick " << tick << " moves at " << speed << " rad/s, "
          << silent << " ticks after the last permit or command";
      if (arm.setpoint && state.servo != arm_state_t::STOPPED) {
        EXPECT_LT(distance, kThere)
            << name << " at tick " << tick << " is not where it was last sent";
      }
      if (arm.was_moving) ++num_stops_;
      arm.was_moving = false;
    } else if (is_moving) {
      arm.was_moving = true;
    }
  }

  static bool IsSame(const arm_setpoint_t& a, const arm_setpoint_t& b) {
    double difference = std::abs(a.opening - b.opening);
    for (size_t i = 0; i < a.position.size(); ++i) {
      difference =
          std::max(difference, std::abs(a.position[i] - b.position[i]));
    }
    return difference < kSame;
  }

  AssemblingCell& cell_;
  std::map<std::string, Arm> arms_;
  int32_t permit_tick_ = 0;
  int32_t max_freeze_ticks_ = 0, max_rest_ticks_ = 0;
  int num_stops_ = 0;
};

}  // namespace cell
