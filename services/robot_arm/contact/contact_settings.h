#pragma once

#include "common/config/config.h"
#include "services/robot_arm/contact/insertion.h"
#include "services/robot_arm/contact/screwing.h"
#include "services/robot_arm/contact_sensor.h"

namespace cell::robot_arm {

// Each part of a contact motion is a section of its own. These throw
// ConfigError naming file:key, also for gains that cannot be stable.

/// `params` with the values of `config`, which names only what differs.
InsertionParams Refined(InsertionParams params, const Config& config);
/// How fast a thread is turned, how hard, and when it is tight depend on the
/// parts and must be named.
ScrewingParams ScrewingFromConfig(const Config& config);
ContactSensor::Params ForceSensorFromConfig(const Config& config);

}  // namespace cell::robot_arm
