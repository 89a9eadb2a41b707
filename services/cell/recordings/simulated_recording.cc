#include "services/cell/recordings/simulated_recording.h"

#include "common/task/task.h"
#include "services/cell/recordings/episode_recorder.h"
#include "services/cell/running/service_registry.h"
#include "services/cell/running/sim_run.h"

namespace cell::cli {
namespace {

Roster TestbedAlone(const Roster& whole) {
  Roster roster;
  roster.task = whole.task;
  for (const auto& entry : whole.entries) {
    if (entry.name == "vtb" || entry.name == "tracker") {
      roster.entries.push_back(entry);
    }
  }
  return roster;
}

}  // namespace

Recording SimulatedRecording(const Deployment& deployment, const Roster& whole,
                             const std::string& script, uint64_t seed,
                             const std::string& build) {
  SimBus bus(TestbedAlone(whole), AllServices(deployment, script, seed));
  EpisodeRecorder recorder(LoadTask(deployment), 1, build);
  RunToEnd(bus, [&](const Message& message) { recorder.Put(message); });
  return recorder.Finish();
}

}  // namespace cell::cli
