#pragma once

#include <map>
#include <string>

#include "common/arms/motion_settings.h"
#include "common/config/config.h"
#include "common/parts/part_table.h"
#include "services/robot_arm/aim_error.h"
#include "services/robot_arm/contact/insertion.h"
#include "services/robot_arm/contact/screwing.h"
#include "services/robot_arm/contact_sensor.h"
#include "services/robot_arm/safety_distances.h"

namespace cell::robot_arm {

/// How arms handle the parts of a task: its skills.yaml.
struct SkillSettings {
  MotionSettings motion;
  FingerSettings fingers;
  SafetyDistances distances;
  std::map<std::string, InsertionParams> insertions;  ///< by type of site
  ScrewingParams screwing;
  ContactSensor::Params force_sensor;
  AimError aim_error;  ///< of evaluations, not of files

  /// @throws ConfigError naming file:key, also for a type that no site has
  /// and for gains that cannot be stable.
  static SkillSettings FromConfig(const Config& config, const PartTable& parts);
};

}  // namespace cell::robot_arm
