#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/bus/roster.h"
#include "common/config/deployment.h"

namespace cell {

/// The run that is measured: arms that assemble, from its first tick on.
inline constexpr uint64_t kMeasuredSeed = 500;
inline constexpr char kMeasuredScript[] = "execution";

/// What a stretch of a run has cost.
struct Cost {
  int32_t num_ticks = 0;
  double wall_s = 0;
  double cpu_s = 0;  ///< processor time of all processes
  /// Processor time within mj_step, if it ran in this process.
  double step_s = 0;
  double resident_mb = 0;
};

/// The first `num_ticks` of the cell in one process.
Cost RunInOneProcess(const Roster& roster, const Deployment& deployment,
                     int32_t num_ticks);

/// The testbed alone, given what the run recorded in `deployment.run_dir` gave
/// it. @throws std::runtime_error naming the first message that differs.
Cost ReplayTestbed(const Roster& roster, const Deployment& deployment);

/// The first `num_ticks` of `cell demo` with these `options`, whose run folder
/// is `run`: each service a process of its own, over LCM.
/// @throws std::runtime_error if the cell ends before.
Cost RunOverLcm(const std::filesystem::path& run, const std::string& deploy,
                const std::vector<std::string>& options, int32_t num_ticks);

}  // namespace cell
