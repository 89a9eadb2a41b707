#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "common/layout/arm_layout.h"

namespace cell::vtb {

/// The position servo of a 6-axis arm as its controller offers it at 125 Hz:
/// follows set-points like a critically damped system of the given bandwidth,
/// after a dead time, within the joints' speed; stands still by itself when
/// set-points stop coming or the force grows too high. A value.
class ArmServo {
 public:
  struct Params {
    double bandwidth = 12;    ///< [Hz] at which it follows to -3 dB
    int dead_ticks = 1;       ///< from a set-point to its effect
    int patience_ticks = 5;   ///< without a set-point, before it holds
    double stop_force = 150;  ///< [N] on the tool: protective stop
  };
  enum class State : int8_t { kFollowing = 0, kHolding = 1, kStopped = 2 };

  /// At `q`; `max_speed` [rad/s] of each joint.
  ArmServo(const Params& params, const Joints& max_speed, const Joints& q);

  /// A set-point [rad] that has come in this tick.
  void Command(const Joints& q, bool clear_stop);
  /// As if the force were 1 N too high: stands still until a set-point clears
  /// it.
  void Stop();
  /// One tick of `dt` [s]; `force` [N] acts on the tool.
  void Update(double dt, double force);

  const Joints& position() const { return q_; }
  const Joints& velocity() const { return v_; }
  State state() const { return state_; }
  /// [N] that it has stopped at, until the stop is cleared.
  double stopped_by() const { return stopped_by_; }

 private:
  void StopAt(double force);
  void MoveTowards(double dt);

  Params params_;
  Joints max_speed_;
  double omega_;  // [rad/s] of the double pole
  Joints q_, v_ = Joints::Zero();
  Joints goal_;
  std::optional<Joints> command_;              // of this tick
  std::deque<std::optional<Joints>> delayed_;  // what came in earlier ticks
  int num_silent_ = 0;                         // ticks without a set-point
  State state_ = State::kHolding;
  double stopped_by_ = 0;
};

}  // namespace cell::vtb
