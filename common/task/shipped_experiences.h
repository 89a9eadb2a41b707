#pragma once

#include <filesystem>
#include <vector>

#include "common/config/deployment.h"
#include "common/experiences/task_experience.h"
#include "common/relational/domain.h"

namespace cell {

/// Folder of a task that holds the experiences which it ships with.
inline constexpr char kExperiencesFolder[] = "experiences";

/// All files *.experiences of the folder, by their names; none if there is no
/// such folder.
std::vector<std::filesystem::path> ExperienceFilesIn(
    const std::filesystem::path& folder);

/// The experiences that the task's learned rules were learned from: those of
/// experiences/*.experiences in its folder, in the order of the files' names.
/// None if its domain.yaml names no learned rules. A person counts as who made
/// them, since the text does not say.
/// @param domain  of the task
/// @throws ConfigError "file:line: ..." for what cannot be read, for
/// objects that the task does not have, and for a file without an experience
std::vector<TaskExperience> ReadShippedExperiences(const Deployment& deployment,
                                                   const Domain& domain);

}  // namespace cell
