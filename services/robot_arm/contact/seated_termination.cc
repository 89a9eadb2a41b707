#include "services/robot_arm/contact/seated_termination.h"

#include <fmt/format.h>

namespace cell::robot_arm {

Termination::Verdict SeatedTermination::Judge(const ContactState& state) const {
  if (!state.is_stalled) return {};
  const double left = DistanceLeft(state.height);
  if (left <= params_.tolerance && left >= -params_.tolerance - params_.give) {
    return {Outcome::kDone, ""};
  }
  return {Outcome::kStuck,
          fmt::format("it is stuck {:.1f} mm from its seat, {:.1f} mm allowed "
                      "(seat.tolerance_mm), by {:.1f} N at the wrist sensor",
                      1e3 * left, 1e3 * params_.tolerance,
                      state.contact.force.norm())};
}

}  // namespace cell::robot_arm
