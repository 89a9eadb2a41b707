#pragma once

#include "common/config/deployment.h"
#include "services/cell/commands/rules_files.h"
#include "services/cell/evaluations/row_identity.h"

namespace cell::cli {

/// Adds all files of config/ and of the task, but hidden ones.
/// @throws std::runtime_error naming one that cannot be read
void AddDeployment(const Deployment& deployment, RowIdentity* identity);

/// Adds data and symbols.
/// @throws std::runtime_error naming one that cannot be read
void AddExperiences(const ExperienceFiles& files, RowIdentity* identity);

}  // namespace cell::cli
