#pragma once

#include <vector>

#include "services/cell/logs/log_finding.h"
#include "services/cell/logs/log_index.h"

namespace cell::cli {

/// The cell's channels on which a log holds messages of other types than this
/// program's: one finding for each channel and fingerprint. With manifests, a
/// stray one among good ones is damage, not a type. Pure.
std::vector<LogFinding> FindForeignTypes(const LogIndex& index,
                                         bool has_manifests);

}  // namespace cell::cli
