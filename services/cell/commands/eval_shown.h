#pragma once

#include "services/cell/commands/commands.h"

namespace cell::cli {

/// Adds `stream`, `groups` and `layers` to the subcommands of `cell eval`.
void AddEvalShown(CLI::App& eval, Action* action);

}  // namespace cell::cli
