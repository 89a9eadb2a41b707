#pragma once

#include <string>
#include <vector>

#include "services/cell/logs/log_finding.h"
#include "services/cell/logs/log_index.h"

namespace cell::cli {

/// Finds bytes in which no event begins, with the numbers of the events lost
/// there; numbers out of order; and in a canonical log stamps that do not agree
/// with its content. Pure.
std::vector<LogFinding> FindOddFrames(const LogIndex& index, bool is_canonical);

/// Something about one entry.
LogFinding FindingAt(const LogIndex& index, size_t entry, std::string text);

}  // namespace cell::cli
