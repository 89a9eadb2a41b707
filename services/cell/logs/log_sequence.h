#pragma once

#include <cstdint>
#include <vector>

#include "services/cell/logs/log_finding.h"
#include "services/cell/logs/log_index.h"

namespace cell::cli {

/// Where the numbers that a log gives its events, 0, 1, 2, ... in each file,
/// jump: one finding for each jump, one for all of them if they are many. An
/// event between two others with consecutive numbers was inserted later. Pure.
std::vector<LogFinding> FindOddNumbers(const LogIndex& index,
                                       bool is_canonical);

/// How a log's stamps should be.
struct StampRules {
  /// [us] An event may be earlier than the one before it by this.
  int64_t backward_us = 0;
  /// False if pauses mean nothing, since manifests show what is missing.
  bool has_silences = true;
};

/// Where a log's time runs back, and where nothing came for long: a second or
/// more, a hundred times as long as half of its events take to come. More than
/// a few such pauses are normal, and not reported. Pure.
std::vector<LogFinding> FindOddStamps(const LogIndex& index,
                                      const StampRules& rules);

}  // namespace cell::cli
