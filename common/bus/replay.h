#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "common/bus/clock_host.h"
#include "common/bus/roster.h"
#include "common/bus/run_log.h"

namespace cell {

/// What became of one service's replay.
struct ReplayResult {
  int64_t num_messages = 0;  ///< recomputed and found equal
  /// First thing that differs, with tick and channel; nothing if all is equal.
  std::optional<std::string> difference;
  /// Last tick before a gap in the log, where the comparison had to end.
  std::optional<int32_t> gap_after;
};

/// Feeds a service (the clock's too) the inputs that a log recorded, restarts
/// it where it was restarted, and compares every message that it publishes
/// with the one in the log, byte for byte.
ReplayResult Replay(const RunLog& log, const Roster& roster,
                    const std::string& service, const ServiceFactory& factory);

}  // namespace cell
