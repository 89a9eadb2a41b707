#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "common/bus/message.h"

namespace cell {

/// An operator's command as it reached the clock: encoded, on COMMAND_*.
struct Command {
  std::string channel;
  Bytes bytes;
};

/// True for channels on which operators may command.
bool IsCommand(const std::string& channel);

/// Orders operators' commands among the messages of the service that is first
/// in the roster.
class CommandGate {
 public:
  /// The commands as messages of `sender` in `tick`. Refuses those too short
  /// for a header, or without a receiver; `is_wanted`: what the service itself
  /// takes.
  std::vector<Message> Pass(
      int32_t tick, int32_t sender, std::vector<Command> commands,
      const std::function<bool(const std::string& channel)>& is_wanted);

  int64_t num_refused() const { return num_refused_; }

 private:
  std::map<std::string, int32_t> next_seq_;
  int64_t num_refused_ = 0;
};

}  // namespace cell
