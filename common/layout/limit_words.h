#pragma once

#include <optional>
#include <string>

#include "cell/arm_stop_t.hpp"

namespace cell {

/// "13.4 N, more than the 12.0 N allowed", with as many digits as the two need
/// to differ. @pre measured > allowed.
std::string Exceeded(double measured, double allowed, const std::string& unit);

/// "the gripper of the right arm measured 13.4 N, more than the 12.0 N allowed
/// (stop_force_n)". Nothing if the message cannot be true.
std::optional<std::string> WhyStopped(const arm_stop_t& stop);

}  // namespace cell
