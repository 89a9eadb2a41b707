#pragma once

#include "common/config/config.h"

namespace cell {

/// How arms move between things: `motion` of a task's skills.yaml.
struct MotionSettings {
  double transit_speed = 1.0;         ///< [rad/s] of the fastest joint
  double transit_acceleration = 2.5;  ///< [rad/s^2]
  double line_speed = 0.12;           ///< [m/s]
  double clearance = 0.008;           ///< [m]
  double approach = 0.10;             ///< [m] straight to a grasp
  double raise = 0.03;                ///< [m] straight up after a grasp

  /// @throws ConfigError naming file:key.
  static MotionSettings FromConfig(const Config& config);
};

/// How fingers go around a part: `fingers` of a task's skills.yaml.
struct FingerSettings {
  double open_margin = 0.014;   ///< [m] beyond the part
  double close_beyond = 0.006;  ///< [m] narrower than the part

  /// @throws ConfigError naming file:key.
  static FingerSettings FromConfig(const Config& config);
};

}  // namespace cell
