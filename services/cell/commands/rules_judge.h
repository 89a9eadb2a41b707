#pragma once

#include <CLI/CLI.hpp>

#include "services/cell/commands/commands.h"

namespace cell::cli {

/// `cell rules judge`.
void AddRulesJudge(CLI::App& rules, Action* action);

}  // namespace cell::cli
