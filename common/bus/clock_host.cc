#include "common/bus/clock_host.h"

#include <utility>

namespace cell {

bool IsCommand(const std::string& channel) {
  return channel.starts_with("COMMAND_");
}

ClockHost::ClockHost(const Roster& roster, const ServiceFactory& factory)
    : stepper_({.name = roster.entries[0].name,
                .truth_role = roster.entries[0].truth_role}),
      service_(factory(stepper_)) {}

std::vector<Message> ClockHost::Tick(int32_t tick, std::vector<Message> inputs,
                                     std::vector<Command> commands) {
  // Tick 0 is for joining: the world begins when everyone listens.
  if (tick == 0) {
    waiting_ = std::move(commands);
    return {};
  }
  commands.insert(commands.begin(), std::make_move_iterator(waiting_.begin()),
                  std::make_move_iterator(waiting_.end()));
  waiting_.clear();
  std::vector<Message> own;
  for (Command& command : commands) {
    if (!IsCommand(command.channel) || !Wants(command.channel) ||
        command.bytes.size() < kWireHeaderEnd) {
      ++num_refused_;
      continue;
    }
    WriteIdentity(tick, 0, next_seq_[command.channel]++, command.bytes);
    own.push_back(*MessageFromWire(command.channel, std::move(command.bytes)));
    inputs.push_back(own.back());
  }
  if (stepper_.Accept(tick, std::move(inputs)) == Stepper::State::kReady) {
    std::vector<Message> outputs = stepper_.Run();
    own.insert(own.end(), std::make_move_iterator(outputs.begin()),
               std::make_move_iterator(outputs.end()));
  }
  return own;
}

}  // namespace cell
