#pragma once

#include <CLI/CLI.hpp>

#include "services/cell/commands/commands.h"

namespace cell::cli {

/// cell rules record
void AddRulesRecord(CLI::App& rules, Action* action);

}  // namespace cell::cli
