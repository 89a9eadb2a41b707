#pragma once

#include <cstdint>
#include <optional>

#include "services/planner/decisions.h"
#include "services/planner/observations.h"

namespace cell::planner {

/// The latest sensed state, and when to ask for another one. Nothing is acted
/// on that was sensed before the last thing that may have changed it.
class Sensing {
 public:
  explicit Sensing(int64_t since_utime) : fresh_utime_(since_utime) {}

  /// An older one than the latest is dropped.
  void Update(const SensedState& sensed);
  /// A state must be at least as young as this from now on.
  void RequireSince(int64_t utime);
  /// Nullptr unless the latest is young enough.
  const SensedState* Fresh() const;
  /// False while it is too early for a state that would be young enough.
  bool IsDue(Instant now) const { return now.utime >= fresh_utime_; }
  /// Asks for the predicates, unless that was done less than a period ago.
  void Ask(Instant now, int64_t period_us, Decisions& out);

 private:
  std::optional<SensedState> latest_;
  int64_t fresh_utime_;
  std::optional<int64_t> asked_utime_;
};

}  // namespace cell::planner
