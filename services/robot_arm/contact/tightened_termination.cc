#include "services/robot_arm/contact/tightened_termination.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "common/layout/limit_words.h"

namespace cell::robot_arm {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

}  // namespace

Termination::Verdict TightenedTermination::Judge(
    const ContactState& state) const {
  const double torque = std::abs(state.contact.torque.z());
  if (torque > params_.torque) {
    if (state.turned >= params_.min_angle) return {Outcome::kDone, ""};
    return {Outcome::kFailed,
            fmt::format("the thread has jammed {:.1f} mm from its seat: the "
                        "wrist sensor measured {} (tight.torque_nm) after "
                        "{:.0f} deg, at least {:.0f} deg are required "
                        "(tight.min_angle_deg)",
                        1e3 * DistanceLeft(state.height),
                        Exceeded(torque, params_.torque, "N m"),
                        state.turned * kDegrees, params_.min_angle * kDegrees)};
  }
  if (state.turned < params_.max_angle) return {};
  return {Outcome::kFailed,
          fmt::format("it has turned by the {:.0f} deg allowed "
                      "(tight.max_angle_deg), the wrist sensor measured "
                      "{:.2f} N m of the {:.2f} N m required "
                      "(tight.torque_nm): the thread does not hold",
                      params_.max_angle * kDegrees, torque, params_.torque)};
}

}  // namespace cell::robot_arm
