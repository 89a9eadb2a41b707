#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/config/deployment.h"
#include "common/experiences/rule_world.h"
#include "common/relational/domain.h"
#include "common/rules/experience.h"

namespace cell::cli {

/// The whole file. @throws std::runtime_error naming it
std::string TextOfFile(const std::filesystem::path& path);

/// Where experiences are, and the symbols that they are written with.
struct ExperienceFiles {
  std::filesystem::path data;
  std::filesystem::path symbols;
};
/// @param data     a file, or a folder with data.dat
/// @param symbols  a file; if empty, symbols.dat beside the data
ExperienceFiles FilesOfExperiences(const std::filesystem::path& data,
                                   const std::filesystem::path& symbols);

/// Reads experiences, and the symbols that they are written with.
/// @param data, symbols  as FilesOfExperiences() takes them
/// @throws RuleError, std::runtime_error naming file and line
rules::ExperienceSet LoadExperiences(const std::filesystem::path& data,
                                     const std::filesystem::path& symbols);

/// The folder that was named, or, if none was, that of the task.
std::filesystem::path ExperiencesFolder(const std::string& named,
                                        const Deployment& deployment);

/// The experiences of a task: all files *.experiences of the folder, by name.
/// @throws RuleError, std::runtime_error naming file and line, or the folder if
/// it has none
std::vector<rules::Experience> TaskExperiences(
    const std::filesystem::path& folder, const RuleWorld& world);

/// @throws RuleError, std::runtime_error naming file and line
rules::NdrRules LoadRules(const std::filesystem::path& path);

/// The domain's first goal if `name` is empty.
/// @throws std::runtime_error naming the goals that there are
const Goal& NamedGoal(const Domain& domain, const std::string& name);

}  // namespace cell::cli
