#pragma once

#include "services/cell/commands/commands.h"

namespace cell::cli {

/// Adds `sec` to the subcommands of `cell eval`.
void AddEvalSec(CLI::App& eval, Action* action);

}  // namespace cell::cli
