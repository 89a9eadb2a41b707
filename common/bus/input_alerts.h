#pragma once

#include <set>
#include <string>

#include "common/bus/bus.h"

namespace cell {

/// Tells people once for each channel why its messages are rejected: STATUS
/// counts how many.
class InputAlerts {
 public:
  /// `bus` must outlive this object.
  explicit InputAlerts(Bus& bus) : bus_(bus) {}

  /// Publishes an ALERT for the first message on the channel. Returns false,
  /// as a handler that rejects does.
  bool Reject(const std::string& channel, const std::string& why);

 private:
  Bus& bus_;
  std::set<std::string> told_;  ///< channels
};

}  // namespace cell
