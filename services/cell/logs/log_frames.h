#pragma once

#include <string>
#include <vector>

#include "services/cell/logs/log_finding.h"
#include "services/cell/logs/log_index.h"

namespace cell::cli {

/// Bytes in which no event begins, with the numbers of the events that they
/// have cost; numbers out of their order; of a canonical log also the stamps
/// that are not as they follow from what it holds. Pure.
std::vector<LogFinding> FindOddFrames(const LogIndex& index, bool is_canonical);

/// Something about one entry.
LogFinding FindingAt(const LogIndex& index, size_t entry, std::string text);

}  // namespace cell::cli
