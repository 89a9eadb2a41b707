#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/bus.h"
#include "common/config/config.h"

namespace cell {

/// The services of a cell: deploy/config/roster.yaml. The first one is the
/// clock. The index in the roster is the base of a service's sender ids.
struct Roster {
  struct Entry {
    std::string name;
    int32_t latency = 1;     ///< ticks that one activation takes, >= 1
    std::string truth_role;  ///< as in truth_access.h; empty: the name
    /// It may publish what the clock's own service reads. The clock's service
    /// acts once these have answered, and the others may still be at work. A
    /// roster that marks no service waits for all.
    bool feeds_clock = false;
  };
  std::string task;  ///< folder under deploy/tasks
  std::vector<Entry> entries;
  /// Names of those that are listed but do not take part: they have an
  /// `option`, for which a run has to ask. As they come last, the others'
  /// sender ids are the same without them.
  std::vector<std::string> absent;
  /// The number of services that may publish, in this run or in another.
  size_t NumListed() const { return entries.size() + absent.size(); }

  /// With those of this `option`; empty: none that has one.
  /// @throws ConfigError, also for duplicate names, an empty roster and an
  /// option that no service has.
  static Roster FromConfig(const Config& config,
                           const std::string& option = "");

  std::optional<size_t> IndexOf(const std::string& name) const;
  /// @throws std::invalid_argument naming the service if it is not there.
  size_t RequireIndexOf(const std::string& name) const;
};

inline constexpr int32_t kMaxServices = 1000;

/// An incarnation's sender id.
constexpr int32_t SenderOf(size_t index, int32_t incarnation) {
  return static_cast<int32_t>(index) + kMaxServices * incarnation;
}

/// The index in the roster of the sender.
constexpr int32_t BaseOf(int32_t sender) {
  return sender % kMaxServices;
}

}  // namespace cell
