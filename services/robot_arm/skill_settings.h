#pragma once

#include <map>
#include <string>

#include "common/config/config.h"
#include "common/parts/part_table.h"
#include "services/robot_arm/aim_error.h"
#include "services/robot_arm/contact/insertion.h"
#include "services/robot_arm/contact/screwing.h"
#include "services/robot_arm/contact_sensor.h"

namespace cell::robot_arm {

/// How arms handle the parts of a task: its skills.yaml.
struct SkillSettings {
  struct Motion {
    double transit_speed = 1.0;         ///< [rad/s] of the fastest joint
    double transit_acceleration = 2.5;  ///< [rad/s^2]
    double line_speed = 0.12;           ///< [m/s]
    double clearance = 0.008;           ///< [m]
    double approach = 0.10;             ///< [m] straight to a grasp
    double raise = 0.03;                ///< [m] straight up after a grasp
  };
  struct Fingers {
    double open_margin = 0.014;   ///< [m] beyond the part
    double close_beyond = 0.006;  ///< [m] narrower than the part
  };
  Motion motion;
  Fingers fingers;
  std::map<std::string, InsertionParams> insertions;  ///< by type of site
  ScrewingParams screwing;
  ContactSensor::Params force_sensor;
  AimError aim_error;  ///< of evaluations, not of files

  /// @throws ConfigError naming file:key, also for a type that no site has
  /// and for gains that cannot be stable.
  static SkillSettings FromConfig(const Config& config, const PartTable& parts);
};

}  // namespace cell::robot_arm
