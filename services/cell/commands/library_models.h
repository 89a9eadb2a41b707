#pragma once

#include <string>

#include "common/sec/role_similarity.h"
#include "common/task/task.h"

namespace cell::cli {

/// The SEC models of a library's file, or of a run folder that has one; without
/// a database those that the task comes with.
RoleSimilarity::Models ModelsOf(const std::string& database, const Task& task);

}  // namespace cell::cli
