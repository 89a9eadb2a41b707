#include "services/planner/sensing.h"

#include <algorithm>

namespace cell::planner {

void Sensing::Update(const SensedState& sensed) {
  if (!latest_ || sensed.utime >= latest_->utime) latest_ = sensed;
}

void Sensing::RequireSince(int64_t utime) {
  fresh_utime_ = std::max(fresh_utime_, utime);
}

const SensedState* Sensing::Fresh() const {
  return latest_ && latest_->utime >= fresh_utime_ ? &*latest_ : nullptr;
}

void Sensing::Ask(Instant now, int64_t period_us, Decisions& out) {
  if (asked_utime_ && now.utime - *asked_utime_ < period_us) return;
  asked_utime_ = now.utime;
  out.sense = true;
}

}  // namespace cell::planner
