#include "services/vtb/attendance.h"

#include <fmt/format.h>

#include "common/bus/bus.h"

namespace cell::vtb {

void Attendance::OnMode(bool is_hold, const std::string& reason, int32_t tick) {
  if (!is_hold) return hold_tick_.reset();
  if (!hold_tick_) hold_tick_ = tick;
  reason_ = reason;
}

std::optional<std::string> Attendance::GiveUpReason(int32_t tick) const {
  if (!patience_ || is_attended_ || !hold_tick_) return std::nullopt;
  const int32_t waited = tick - *hold_tick_;
  if (waited < *patience_) return std::nullopt;
  return fmt::format(
      "the cell has been held for {:.0f} s, and no operator has resumed it: {}",
      1e-6 * static_cast<double>(waited * kTickUs), reason_);
}

}  // namespace cell::vtb
