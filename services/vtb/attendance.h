#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace cell::vtb {

/// Decides when a run gives up waiting for an operator: the cell is held, and
/// no operator has sent a command for so long. After any command of an operator
/// the run waits without a limit. A value; times in ticks.
class Attendance {
 public:
  /// `patience`: nullopt if an operator is known to be there.
  explicit Attendance(std::optional<int32_t> patience) : patience_(patience) {}

  void OnOperator() { is_attended_ = true; }
  /// The mode from the supervisor. `reason` of a hold, in plain words.
  void OnMode(bool is_hold, const std::string& reason, int32_t tick);
  /// Forgets the hold, but not that there is an operator.
  void BeginEpisode() { hold_tick_.reset(); }
  /// Why the run should end; nullopt while it should wait.
  std::optional<std::string> GiveUpReason(int32_t tick) const;

 private:
  std::optional<int32_t> patience_;
  bool is_attended_ = false;
  std::optional<int32_t> hold_tick_;  // since when it holds
  std::string reason_;
};

}  // namespace cell::vtb
