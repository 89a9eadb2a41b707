#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/actions/action_record.h"
#include "services/cell/commands/commands.h"

namespace cell::cli {

/// The subcommands of `cell library` that change records.
void AddLibraryEdits(CLI::App& library, Action* action);

/// The file of a library that is named by it, or by a run folder that has one.
std::filesystem::path LibraryFile(const std::string& database);

/// The demonstrations that taught how the action shows, a line each:
/// "shown 2 times by assembly 1 (build 0.1.0)".
std::vector<std::string> DemonstrationsOf(const ActionRecord& record);

}  // namespace cell::cli
