#pragma once

#include <string>

#include "common/recordings/recording.h"
#include "services/cell/running/run_folder.h"

namespace cell::cli {

/// The recording of episode `number` (from 1) of a run of the testbed: for each
/// TRACKS of the log the TRUTH_POSES that it was made of, of the task's parts
/// and hands. `build` is put down as the build that simulated it.
/// @throws std::runtime_error naming the run folder if its log has no such
/// episode, or no truth of it.
Recording RecordingOfRun(const RunFolder& run, int number,
                         const std::string& build);

}  // namespace cell::cli
