#pragma once

#include <string>

#include "common/node/cell_files.h"

namespace cell::cli {

/// Reads the files of a task - parts, domain, cell, demonstrators, skills - and
/// the roster, and holds them against each other: every name that one takes
/// from another must be there, every action must be possible for each of its
/// agents, every grip must be one of a hand, and
/// every service can be built from its own. `demonstration` names scripts
/// ("a+b"), empty the configured ones. Every command that starts a cell calls
/// it first.
/// @throws ConfigError "file:key: message (line N)", std::invalid_argument for
/// a demonstration that no script has.
void CheckTask(const CellFiles& files, const std::string& demonstration);

}  // namespace cell::cli
