#pragma once

#include <cstdint>
#include <string>

#include "common/bus/roster.h"
#include "common/config/deployment.h"
#include "common/recordings/recording.h"

namespace cell::cli {

/// Simulates the person of a script, with testbed and tracker alone, and
/// records it: nothing that depends on an estimator.
/// @param script  of the task's demonstrators.yaml
/// @param whole  roster of the cell
/// @param build  put down in the recording
Recording SimulatedRecording(const Deployment& deployment, const Roster& whole,
                             const std::string& script, uint64_t seed,
                             const std::string& build);

}  // namespace cell::cli
