#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace cell::vtb {

/// Tells when a run waits in vain for an operator: the cell holds, and nobody
/// has said anything for so long. Once an operator has spoken there is one, and
/// waiting is right. A value; times in ticks.
class Attendance {
 public:
  /// `patience`: nothing if an operator is known to be there.
  explicit Attendance(std::optional<int32_t> patience) : patience_(patience) {}

  void HearOperator() { is_attended_ = true; }
  /// What the supervisor says. `reason` of a hold, in plain words.
  void OnMode(bool is_hold, const std::string& reason, int32_t tick);
  /// Forgets a hold, not the operator.
  void BeginEpisode() { hold_tick_.reset(); }
  /// Why waiting is in vain; nothing if it is not.
  std::optional<std::string> WhyInVain(int32_t tick) const;

 private:
  std::optional<int32_t> patience_;
  bool is_attended_ = false;
  std::optional<int32_t> hold_tick_;  // since when it holds
  std::string reason_;
};

}  // namespace cell::vtb
