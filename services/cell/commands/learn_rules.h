#pragma once

#include <CLI/CLI.hpp>

#include "services/cell/commands/commands.h"

namespace cell::cli {

/// cell learn rules
void AddLearnRules(CLI::App& learn, Action* action);

}  // namespace cell::cli
