#pragma once

#include <CLI/CLI.hpp>

#include "services/cell/commands/commands.h"

namespace cell::cli {

/// cell rules compare
void AddRulesCompare(CLI::App& rules, Action* action);

}  // namespace cell::cli
