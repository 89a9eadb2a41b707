#include "services/cell/evaluations/demonstration_set.h"

#include <fmt/format.h>

#include <stdexcept>

#include "common/files/draft.h"
#include "common/node/run_service.h"
#include "common/recordings/recording_text.h"
#include "services/cell/evaluations/job_pool.h"
#include "services/cell/recordings/simulated_recording.h"
#include "services/cell/running/progress.h"

namespace cell::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kRecordedDecimals = 5;  // [m] a hundredth of a millimetre

}  // namespace

std::vector<fs::path> MakeDemonstrations(const DemonstrationSet& set,
                                         const CellFiles& files) {
  MakeFolder(set.folder);
  const auto script_of = [&](uint64_t seed) {
    return set.scripts[seed % set.scripts.size()];
  };
  std::vector<fs::path> paths;
  std::vector<size_t> missing;
  for (int i = 0; i < set.num; ++i) {
    const uint64_t seed = set.seed + static_cast<uint64_t>(i);
    paths.push_back(set.folder /
                    fmt::format("{}-{}.recording", script_of(seed), seed));
    if (!fs::exists(paths.back())) missing.push_back(paths.size() - 1);
  }
  const auto simulate = [&](size_t i) {
    const uint64_t seed = set.seed + i;
    const Recording recording = SimulatedRecording(
        files.deployment, files.roster, script_of(seed), seed, "");
    WriteFile(paths[i], RecordingToText(recording, kRecordedDecimals));
    return std::string("made");
  };
  Progress progress;
  size_t num_done = 0;
  const auto& stop = StopOnSignals();
  RunJobs(
      missing, set.num_processes, simulate,
      [&](size_t i, const std::string& result) {
        if (result.empty()) {
          throw std::runtime_error(paths[i].string() +
                                   ": could not be simulated");
        }
        ++num_done;
      },
      [&] {
        progress.Show(fmt::format("{}/{} demonstrations simulated, {:.0f} s",
                                  num_done, missing.size(),
                                  progress.ElapsedSeconds()));
        return !stop;
      });
  if (stop) {
    throw std::runtime_error(
        "stopped; repeat the command to simulate the other demonstrations");
  }
  return paths;
}

}  // namespace cell::cli
