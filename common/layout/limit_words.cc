#include "common/layout/limit_words.h"

#include <fmt/format.h>

#include <cmath>

namespace cell {

std::string Exceeded(double measured, double allowed, const std::string& unit) {
  constexpr int kMaxDigits = 9;
  for (int digits = 1;; ++digits) {
    const std::string value = fmt::format("{:.{}f}", measured, digits);
    const std::string limit = fmt::format("{:.{}f}", allowed, digits);
    if (value == limit && digits < kMaxDigits) continue;
    return fmt::format("{} {}, more than the {} {} allowed", value, unit, limit,
                       unit);
  }
}

std::optional<std::string> WhyStopped(const arm_stop_t& stop) {
  if (!std::isfinite(stop.measured) || !std::isfinite(stop.allowed) ||
      stop.measured <= stop.allowed || stop.where.empty()) {
    return std::nullopt;
  }
  return fmt::format("{} measured {} ({})", stop.where,
                     Exceeded(stop.measured, stop.allowed, stop.unit),
                     stop.limit);
}

}  // namespace cell
