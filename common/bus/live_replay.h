#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/clock_host.h"
#include "common/bus/live_log.h"
#include "common/bus/roster.h"

namespace cell {

/// What became of the replay of one service of a live cell.
struct LiveReplayResult {
  int64_t num_messages = 0;  ///< recomputed and found equal
  int num_incarnations = 0;  ///< in the log
  /// First thing that differs, with tick and channel.
  std::optional<std::string> difference;
  /// What the log lacks, so that the rest of an incarnation cannot be
  /// recomputed.
  std::vector<std::string> gaps;
  int64_t num_unrecorded = 0;  ///< recomputed, but the log lacks them
  /// Incarnations that began before the log: their state is not known.
  std::vector<std::string> skipped;
};

/// Gives each incarnation of a service, step by step, the inputs that the
/// journal names, and compares every message that it publishes with the one in
/// the log, byte for byte.
LiveReplayResult ReplayLive(const LiveLog& log, const Roster& roster,
                            const std::string& service,
                            const ServiceFactory& factory);

}  // namespace cell
