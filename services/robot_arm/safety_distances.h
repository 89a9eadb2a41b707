#pragma once

#include "common/config/config.h"

namespace cell::robot_arm {

/// What an arm keeps from people and from other arms: `distances` of a task's
/// skills.yaml.
struct SafetyDistances {
  double hands = 0.25;          ///< [m] of a place that the fingers go to
  double hands_at_work = 0.10;  ///< [m] of hands that move or hold something
  /// [m] So near to these it does not even draw back.
  double hands_too_near = 0.05;
  double in_hand = 0.015;       ///< [m] nearer than this a hand holds a part
  double standing_arm = 0.006;  ///< [m] of another arm at rest
  double moving_arm = 0.06;     ///< [m] of another arm that moves
  double patience = 15;         ///< [s] with people's hands at a place

  /// @throws ConfigError naming file:key.
  static SafetyDistances FromConfig(const Config& config);
};

}  // namespace cell::robot_arm
