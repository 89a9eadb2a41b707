#pragma once

#include <vector>

#include "common/config/deployment.h"
#include "common/experiences/task_experience.h"
#include "common/relational/domain.h"

namespace cell {

/// The experiences that the task's learned rules were learned from: those of
/// experiences/*.experiences in its folder, in the order of the files' names.
/// None if its domain.yaml names no learned rules. A person counts as who made
/// them, since the text does not say.
/// @param domain  of the task
/// @throws ConfigError "file:line: ..." for what cannot be read, and for
/// objects that the task does not have
std::vector<TaskExperience> ReadShippedExperiences(const Deployment& deployment,
                                                   const Domain& domain);

}  // namespace cell
