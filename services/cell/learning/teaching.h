#pragma once

#include <cstdint>
#include <string>

#include "common/config/deployment.h"
#include "common/recordings/recording.h"

namespace cell::cli {

/// Simulates the person of a script who shows a cell that recognises nothing
/// yet what to do, and names what it asks for, as an operator would: by
/// COMMAND_NAME. The run is kept in a folder runs/learn-...
/// @param build  put down in the recording
/// @throws std::runtime_error if the run does not come to its end.
Recording Teach(const Deployment& source, const std::string& script,
                uint64_t seed, const std::string& build);

}  // namespace cell::cli
