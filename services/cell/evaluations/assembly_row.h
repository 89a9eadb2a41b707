#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "common/bus/roster.h"
#include "common/config/deployment.h"

namespace cell::cli {

/// A row of an evaluation: one assembly by the cell in one process, scored by
/// the ground truth at its end, its motions checked on the way. `script`: of
/// the task's demonstrators.yaml.
nlohmann::json RunAssembly(const std::string& script, uint64_t seed,
                           const Deployment& deployment, const Roster& roster);

/// What a row says of the motions in its run.
bool HasKeptLimits(const nlohmann::json& row);
bool HasHitNothing(const nlohmann::json& row);

}  // namespace cell::cli
