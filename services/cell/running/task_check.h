#pragma once

#include <string>
#include <vector>

#include "common/node/cell_files.h"

namespace cell::cli {

/// What a run is asked for, beside what its files say.
struct RunRequest {
  std::string demonstration;  ///< scripts ("a+b"); empty: the configured ones
  bool has_cameras = false;   ///< services with the option "cameras" take part
  std::vector<std::string> help_steps;  ///< actions left to a person
};

/// Reads the files of a task - parts, domain, cell, demonstrators, skills - and
/// the roster, and holds them against each other: every name that one takes
/// from another must be there, every action must be possible for each of its
/// agents, every grip must be one of a hand, and every service that takes part
/// can be built from its own; and all must be told of the same pose noise.
/// Every command that starts a cell calls it before it copies them, so that
/// errors name the files that their user knows.
/// @throws ConfigError "file:key: message (line N)", std::invalid_argument for
/// a demonstration that no script has and an action that the robot has not.
void CheckTask(const CellFiles& files, const RunRequest& request = {});

}  // namespace cell::cli
