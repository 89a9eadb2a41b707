#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/experiences/rule_world.h"
#include "common/rules/experience.h"

namespace cell::cli {

/// The whole file. @throws std::runtime_error naming it
std::string TextOfFile(const std::filesystem::path& path);

/// Reads experiences, and the symbols that they are written with.
/// @param data     a file, or a folder with data.dat
/// @param symbols  a file; if empty, symbols.dat beside the data
/// @throws RuleError, std::runtime_error naming file and line
rules::ExperienceSet LoadExperiences(const std::filesystem::path& data,
                                     const std::filesystem::path& symbols);

/// The experiences of a task: all files *.experiences of the folder, by name.
/// @throws RuleError, std::runtime_error naming file and line, or the folder if
/// it has none
std::vector<rules::Experience> TaskExperiences(
    const std::filesystem::path& folder, const RuleWorld& world);

/// @throws RuleError, std::runtime_error naming file and line
rules::NdrRules LoadRules(const std::filesystem::path& path);

}  // namespace cell::cli
