#include "common/bus/clock_host.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace cell {
namespace {

/// Commands that other services than the clock's take. A fixed list, so that
/// nobody can fill the bus with channels of his own making.
constexpr std::array<std::string_view, 2> kPassedOn = {"COMMAND_GOAL",
                                                       "COMMAND_MODE"};

bool IsPassedOn(const std::string& channel) {
  return std::find(kPassedOn.begin(), kPassedOn.end(), channel) !=
         kPassedOn.end();
}

}  // namespace

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
    const bool is_ours = IsCommand(command.channel) && Wants(command.channel);
    if ((!is_ours && !IsPassedOn(command.channel)) ||
        command.bytes.size() < kWireHeaderEnd) {
      ++num_refused_;
      continue;
    }
    WriteIdentity(tick, 0, next_seq_[command.channel]++, command.bytes);
    own.push_back(*MessageFromWire(command.channel, std::move(command.bytes)));
    if (is_ours) inputs.push_back(own.back());
  }
  if (stepper_.Accept(tick, std::move(inputs)) == Stepper::State::kReady) {
    std::vector<Message> outputs = stepper_.Run();
    own.insert(own.end(), std::make_move_iterator(outputs.begin()),
               std::make_move_iterator(outputs.end()));
  }
  return own;
}

}  // namespace cell
