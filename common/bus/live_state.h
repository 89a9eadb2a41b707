#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace cell {

/// What the services of a live cell share on disk: the instant from which its
/// ticks count, and how often each service has started. Several processes may
/// use it at the same time.
class LiveState {
 public:
  /// Makes the folder if it is not there.
  /// @throws std::runtime_error naming the folder or file that cannot be used.
  explicit LiveState(std::filesystem::path dir);

  /// [us of the monotonic clock] of tick 0: as set by CountFrom(), else that of
  /// the first call since Forget(); if that lies ahead (after a boot), now.
  int64_t Epoch(int64_t now_us) const;

  /// How often `service` has started before; counts this start. On disk before
  /// it returns: no identity is given twice.
  int32_t NextIncarnation(const std::string& service) const;

  /// Ticks count from 0 again at the next Epoch(). Only while no service runs.
  void Forget() const;
  /// Ticks count from `epoch_us` on. Only while no service runs.
  void CountFrom(int64_t epoch_us) const;

 private:
  std::filesystem::path dir_;
};

}  // namespace cell
