#pragma once

namespace cell {

/// [s] Period of the arm loop.
inline constexpr double kDt = 0.008;

}  // namespace cell
