#pragma once

#include <optional>
#include <string>

#include "services/robot_arm/arm.h"

namespace cell::robot_arm {

/// Why the arm can do nothing with the part: there is none, it is not seen, or
/// the hand is full. Nothing if it can.
std::optional<std::string> WhyNoUseOf(const std::string& part, const Arm& arm);

}  // namespace cell::robot_arm
