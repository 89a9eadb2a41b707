#include "services/robot_arm/contact/contact_limits.h"

#include <fmt/format.h>

#include "common/layout/limit_words.h"

namespace cell::robot_arm {

std::optional<std::string> ContactLimits::WhyExceeded(double force, double time,
                                                      double left) const {
  if (force > params_.force) {
    return fmt::format("the wrist sensor measured {} (limits.force_n)",
                       Exceeded(force, params_.force, "N"));
  }
  if (time > params_.time) {
    return fmt::format(
        "it is {:.1f} mm from its seat after the {:.0f} s allowed "
        "(limits.time_s)",
        1e3 * left, params_.time);
  }
  return std::nullopt;
}

}  // namespace cell::robot_arm
