#pragma once

#include <filesystem>
#include <memory>

#include "common/config/deployment.h"
#include "services/library/action_store.h"

namespace cell::library {

/// library.db in a run folder.
inline constexpr char kDatabaseName[] = "library.db";

/// What a library of this deployment keeps its actions in: the file `database`;
/// if it is empty, library.db in the run folder; without one, memory. Empty
/// at first, it gets the task's actions. A run folder gets library.json, what
/// is in it at the start of the run; a run that is repeated starts from that.
/// @throws StoreError, ConfigError.
std::shared_ptr<ActionStore> OpenStore(const Deployment& deployment,
                                       const std::filesystem::path& database);

}  // namespace cell::library
