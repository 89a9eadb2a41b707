#include "common/bus/command_gate.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace cell {
namespace {

/// Commands that other services than the first take. A fixed list, so that no
/// sender can fill the bus with channels that it makes up.
constexpr std::array<std::string_view, 5> kPassedOn = {
    "COMMAND_CONFIRM", "COMMAND_GOAL", "COMMAND_LIBRARY", "COMMAND_MODE",
    "COMMAND_NAME"};

bool IsPassedOn(const std::string& channel) {
  return std::find(kPassedOn.begin(), kPassedOn.end(), channel) !=
         kPassedOn.end();
}

}  // namespace

bool IsCommand(const std::string& channel) {
  return channel.starts_with("COMMAND_");
}

std::vector<Message> CommandGate::Pass(
    int32_t tick, int32_t sender, std::vector<Command> commands,
    const std::function<bool(const std::string&)>& is_wanted) {
  std::vector<Message> messages;
  for (Command& command : commands) {
    if (!IsCommand(command.channel) ||
        (!is_wanted(command.channel) && !IsPassedOn(command.channel)) ||
        command.bytes.size() < kWireHeaderEnd) {
      ++num_refused_;
      continue;
    }
    WriteIdentity(tick, sender, next_seq_[command.channel]++, command.bytes);
    messages.push_back(
        *MessageFromWire(command.channel, std::move(command.bytes)));
  }
  return messages;
}

}  // namespace cell
