#include "common/bus/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "common/bus/manifest.h"
#include "common/bus/stepper.h"

namespace cell {
namespace {

// Messages that reach services in tick k: the clock's of k, and those of k - 1
// that the manifest of k names.
std::vector<Message> InputsOf(const RunLog& log, const RunLog::Tick& tick) {
  std::vector<Message> inputs;
  const int32_t k = tick.manifest.header.tick;
  const auto before = log.ticks().find(k - 1);
  for (const MessageId& id : MessagesIn(tick.manifest.flows)) {
    const auto& source = id.sender == 0 || before == log.ticks().end()
                             ? tick.messages
                             : before->second.messages;
    for (const Message& message : source) {
      if (message.channel == id.channel && message.sender == id.sender &&
          message.seq == id.seq && message.digest == id.digest) {
        inputs.push_back(message);
      }
    }
  }
  return inputs;
}

// Compares what a replay computes with what the log holds, tick by tick.
class Comparison {
 public:
  explicit Comparison(const RunLog& log) : log_(log) {}

  void Add(const std::vector<Message>& outputs) {
    for (const Message& message : outputs) {
      computed_[message.tick].push_back(message);
    }
  }

  /// Compares all of `sender` in `tick`.
  void Check(int32_t tick, int32_t sender) {
    std::vector<Message> computed = std::move(computed_[tick]);
    computed_.erase(tick);
    std::sort(computed.begin(), computed.end(), OrderedBefore);
    std::vector<Message> recorded = log_.ticks().at(tick).messages;
    std::erase_if(recorded, [sender](const Message& message) {
      return message.sender != sender || message.channel == kTickChannel ||
             (sender == 0 && IsCommand(message.channel));
    });
    const size_t num = std::max(computed.size(), recorded.size());
    for (size_t i = 0; i < num && !result_.difference; ++i) {
      if (i < computed.size() && i < recorded.size() &&
          computed[i].channel == recorded[i].channel &&
          *computed[i].bytes == *recorded[i].bytes) {
        ++result_.num_messages;
        continue;
      }
      const bool is_extra =
          i < computed.size() &&
          (i >= recorded.size() || OrderedBefore(computed[i], recorded[i]));
      const Message& odd = is_extra ? computed[i] : recorded[i];
      const char* how = i < computed.size() && i < recorded.size() &&
                                computed[i].channel == recorded[i].channel
                            ? "differs from the recorded one"
                        : is_extra ? "was not recorded"
                                   : "was not recomputed";
      result_.difference =
          fmt::format("tick {}: {} seq {} {}", tick, odd.channel, odd.seq, how);
    }
  }

  const ReplayResult& result() const { return result_; }

  /// What is behind a gap in the log cannot be recomputed.
  void EndAtGap(int32_t last_tick) { result_.gap_after = last_tick; }

 private:
  const RunLog& log_;
  std::map<int32_t, std::vector<Message>> computed_;
  ReplayResult result_;
};

// One incarnation of the service: from its join tick to the tick before its
// death.
struct Incarnation {
  int32_t join_tick;
  int32_t end_tick;  // first tick that it does not handle
  int32_t sender;
};

std::vector<Incarnation> IncarnationsOf(const RunLog& log,
                                        const std::string& service) {
  std::vector<Incarnation> incarnations;
  for (const auto& [k, tick] : log.ticks()) {
    for (const joined_t& joined : tick.manifest.joined) {
      if (joined.name != service) continue;
      if (!incarnations.empty())
        incarnations.back().end_tick = joined.death_tick;
      incarnations.push_back({k, log.ticks().rbegin()->first, joined.sender});
    }
  }
  return incarnations;
}

ReplayResult ReplayClock(const RunLog& log, const Roster& roster,
                         const ServiceFactory& factory) {
  ClockHost host(roster, factory);
  Comparison comparison(log);
  for (const auto& [k, tick] : log.ticks()) {
    if (k > 0 && !log.ticks().contains(k - 1)) {
      comparison.EndAtGap(k - 1);
      break;
    }
    std::vector<Message> inputs;
    std::vector<Command> commands;
    for (const Message& message : InputsOf(log, tick)) {
      if (message.sender == 0 && IsCommand(message.channel)) {
        commands.push_back({message.channel, *message.bytes});
      } else if (message.sender != 0 && host.Wants(message.channel)) {
        inputs.push_back(message);
      }
    }
    std::vector<Message> outputs = host.Tick(k, inputs, std::move(commands));
    std::erase_if(outputs, [](const Message& message) {
      return IsCommand(message.channel);
    });
    comparison.Add(outputs);
    comparison.Check(k, 0);
    if (comparison.result().difference) break;
  }
  return comparison.result();
}

}  // namespace

ReplayResult Replay(const RunLog& log, const Roster& roster,
                    const std::string& service, const ServiceFactory& factory) {
  const size_t index = roster.RequireIndexOf(service);
  if (index == 0) return ReplayClock(log, roster, factory);
  Comparison comparison(log);
  for (const Incarnation& incarnation : IncarnationsOf(log, service)) {
    Stepper stepper(StepperParams(roster, index, incarnation.sender));
    const std::unique_ptr<Service> object = factory(stepper);
    for (int32_t k = incarnation.join_tick; k < incarnation.end_tick; ++k) {
      const auto it = log.ticks().find(k);
      if (it == log.ticks().end()) {
        comparison.EndAtGap(k - 1);
        return comparison.result();
      }
      std::vector<Message> inputs;
      if (k > incarnation.join_tick) inputs = InputsOf(log, it->second);
      std::erase_if(inputs, [&](const Message& message) {
        return !stepper.Wants(message.channel);
      });
      if (stepper.Wants(kTickChannel)) {
        inputs.push_back(TickMessage(it->second.manifest));
      }
      if (stepper.Accept(k, std::move(inputs)) == Stepper::State::kReady) {
        comparison.Add(stepper.Run());
      }
      comparison.Check(k, incarnation.sender);
      if (comparison.result().difference) return comparison.result();
    }
  }
  return comparison.result();
}

}  // namespace cell
