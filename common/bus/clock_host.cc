#include "common/bus/clock_host.h"

#include <iterator>
#include <utility>

namespace cell {

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
  std::vector<Message> own =
      gate_.Pass(tick, 0, std::move(commands),
                 [this](const std::string& channel) { return Wants(channel); });
  for (const Message& command : own) {
    if (Wants(command.channel)) inputs.push_back(command);
  }
  if (stepper_.Accept(tick, std::move(inputs)) == Stepper::State::kReady) {
    std::vector<Message> outputs = stepper_.Run();
    own.insert(own.end(), std::make_move_iterator(outputs.begin()),
               std::make_move_iterator(outputs.end()));
  }
  return own;
}

}  // namespace cell
