#pragma once

#include <numbers>

namespace cell {

/// One degree [rad].
inline constexpr double kDegree = std::numbers::pi / 180;

}  // namespace cell
