#include "services/cell/recordings/run_recording.h"

#include <fmt/format.h>

#include <stdexcept>

#include "common/bus/run_log.h"
#include "common/task/task.h"
#include "services/cell/recordings/episode_recorder.h"

namespace cell::cli {

Recording RecordingOfRun(const RunFolder& run, int number,
                         const std::string& build) {
  EpisodeRecorder recorder(LoadTask(run.deployment), number, build);
  const RunLog log = RunLog::Load(run.path);
  for (const auto& [tick, entry] : log.ticks()) {
    for (const Message& message : entry.messages) recorder.Put(message);
  }
  if (!recorder.has_episode()) {
    throw std::runtime_error(fmt::format("{}: the log has no episode {}",
                                         run.path.string(), number));
  }
  Recording recording = recorder.Finish();
  if (recording.frames.empty()) {
    throw std::runtime_error(fmt::format(
        "{}: episode {} of the log has no TRUTH_POSES and TRACKS to record",
        run.path.string(), number));
  }
  return recording;
}

}  // namespace cell::cli
