#include "common/bus/live_replay.h"

#include <fmt/format.h>

#include <memory>
#include <set>
#include <utility>

#include "common/bus/live_node.h"
#include "common/bus/manifest.h"

namespace cell {
namespace {

class IncarnationReplay {
 public:
  IncarnationReplay(const LiveLog& log, const Roster& roster, size_t index,
                    int32_t sender, const ServiceFactory& factory)
      : log_(log),
        stepper_(LiveStepperParams(roster, index, sender)),
        service_(factory(stepper_)),
        sender_(sender) {}

  void Run(const std::vector<step_t>& steps, LiveReplayResult* result) {
    int32_t expected = 0;
    for (const step_t& step : steps) {
      if (step.header.seq != expected++) {
        result->gaps.push_back(
            fmt::format("tick {}: the log lacks STEP sender {} seq {}",
                        step.header.tick, sender_, expected - 1));
        return;
      }
      if (!Replay(step, result)) return;
    }
    FindExtra(steps.back().header.tick, result);
  }

 private:
  // Returns false if the rest of the incarnation cannot be replayed.
  bool Replay(const step_t& step, LiveReplayResult* result) {
    std::vector<Message> inputs;
    for (const MessageId& id : MessagesIn(step.flows)) {
      const Message* message = log_.Find(id);
      if (message == nullptr) {
        result->gaps.push_back(
            fmt::format("tick {}: the step got {}, which the log lacks",
                        step.header.tick, ToString(id)));
        return false;
      }
      inputs.push_back(*message);
    }
    if (stepper_.Accept(step.header.tick, std::move(inputs)) !=
        Stepper::State::kReady) {
      return true;
    }
    for (const Message& output : stepper_.Run()) {
      computed_.insert({output.channel, output.seq});
      if (log_.Find({output.channel, output.sender, output.seq,
                     output.digest}) != nullptr) {
        ++result->num_messages;
      } else if (!log_.Has(output.channel, output.sender, output.seq)) {
        ++result->num_unrecorded;
      } else {
        result->difference =
            fmt::format("tick {}: {} seq {} differs from the log", output.tick,
                        output.channel, output.seq);
        return false;
      }
    }
    return true;
  }

  void FindExtra(int32_t last_tick, LiveReplayResult* result) const {
    for (const Message* said : log_.SaidBy(sender_)) {
      if (said->tick > last_tick ||
          computed_.contains({said->channel, said->seq})) {
        continue;
      }
      result->difference = fmt::format("tick {}: {} seq {} was not recomputed",
                                       said->tick, said->channel, said->seq);
      return;
    }
  }

  const LiveLog& log_;
  Stepper stepper_;
  std::unique_ptr<Service> service_;
  int32_t sender_;
  std::set<std::pair<std::string, int32_t>> computed_;  // channel, seq
};

}  // namespace

LiveReplayResult ReplayLive(const LiveLog& log, const Roster& roster,
                            const std::string& service,
                            const ServiceFactory& factory) {
  const size_t index = roster.RequireIndexOf(service);
  LiveReplayResult result;
  for (const auto& [sender, steps] : log.incarnations()) {
    if (static_cast<size_t>(BaseOf(sender)) != index) continue;
    ++result.num_incarnations;
    if (steps.front().header.seq != 0) {
      result.skipped.push_back(
          fmt::format("sender {} had started before the log begins", sender));
      continue;
    }
    IncarnationReplay(log, roster, index, sender, factory).Run(steps, &result);
    if (result.difference) break;
  }
  return result;
}

}  // namespace cell
