#include "services/cell/learning/teaching.h"

#include "common/bus/decode.h"
#include "common/bus/sim_bus.h"
#include "common/node/run_service.h"
#include "common/task/task.h"
#include "services/cell/learning/speaker.h"
#include "services/cell/recordings/run_recording.h"
#include "services/cell/running/run_folder.h"
#include "services/cell/running/service_registry.h"

namespace cell::cli {
namespace {

/// The person answers after half a second: rounded for the recording, the
/// tracks may give the manipulation's end a frame or two later.
constexpr int32_t kAnswerTicks = 63;
constexpr int32_t kDeadlineTicks = 125;

void Say(command_name_t command, SimBus& bus) {
  const int32_t now = bus.last_tick().header.tick;
  command.header.utime = now * kTickUs;
  command.deadline_utime = (now + kDeadlineTicks) * kTickUs;
  bus.Schedule(SimBus::TimedCommand{now + kAnswerTicks,
                                    {"COMMAND_NAME", Bus::Encode(command)}});
}

}  // namespace

Recording Teach(const Deployment& source, const std::string& script,
                uint64_t seed, const std::string& build) {
  const Task task = LoadTask(source);
  const auto demonstrations = vtb::Demonstrations::FromConfig(
      source.OfTask("demonstrators.yaml"), task.parts);
  const Speaker speaker(demonstrations, task.parts);
  const RunFolder run = RunFolder::Create("", "learn", source, script, seed);
  run.ForgetEventChains();
  {
    SimBus bus(run.roster, AllServices(run.deployment, script, seed));
    const auto& stop = StopOnSignals();
    while (bus.Step()) {
      if (stop) run.Stopped();
      for (const Message& message : bus.last_messages()) {
        if (message.channel != "ACTION") continue;
        const auto action = Decode<recognised_action_t>(message);
        if (!action) continue;
        const auto said =
            speaker.Answer(*action, demonstrations.scripts.at(script));
        if (said) Say(*said, bus);
      }
    }
  }
  return RecordingOfRun(RunFolder::Open(run.path.string()), 1, build);
}

}  // namespace cell::cli
