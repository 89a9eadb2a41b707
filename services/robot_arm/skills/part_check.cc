#include "services/robot_arm/skills/part_check.h"

namespace cell::robot_arm {

std::optional<std::string> WhyNoUseOf(const std::string& part, const Arm& arm) {
  if (arm.parts().Find(part) == nullptr) {
    return "there is no part '" + part + "'";
  }
  if (arm.held() && arm.held()->part != part && arm.SiteOfHeld() == nullptr) {
    return "it holds " + arm.held()->part;
  }
  if (!arm.poses().contains(part)) return "the pose of " + part + " is unknown";
  return std::nullopt;
}

}  // namespace cell::robot_arm
