#pragma once

#include <Eigen/Core>
#include <map>
#include <string>

#include "common/arms/motion_settings.h"
#include "common/config/config.h"
#include "common/parts/part_table.h"
#include "services/robot_arm/aim_error.h"
#include "services/robot_arm/insertion.h"
#include "services/robot_arm/turning.h"

namespace cell::robot_arm {

/// How arms handle the parts of a task: its skills.yaml.
struct SkillSettings {
  /// The last way to a site of some type.
  struct Seating {
    Insertion::Params insertion;
    Eigen::Vector2d aim = Eigen::Vector2d::Zero();  ///< [m] in S, beside it
  };

  MotionSettings motion;
  FingerSettings fingers;
  std::map<std::string, Seating> seatings;  ///< by type of site
  Turning::Params turning;                  ///< pitch as of the thread
  AimError aim_error;                       ///< of evaluations, not of files

  /// @throws ConfigError naming file:key, also for a type that no site has
  /// and for gains that cannot be stable.
  static SkillSettings FromConfig(const Config& config, const PartTable& parts);
};

}  // namespace cell::robot_arm
