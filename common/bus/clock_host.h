#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/bus/roster.h"
#include "common/bus/stepper.h"

namespace cell {

/// An operator's command as it reached the clock: encoded, on COMMAND_*.
struct Command {
  std::string channel;
  Bytes bytes;
};

/// Builds a service on a bus. Called once per life.
using ServiceFactory = std::function<std::unique_ptr<Service>(Bus&)>;

/// True for channels on which operators may command.
bool IsCommand(const std::string& channel);

/// Runs the service that owns time, tick by tick, and gives operators'
/// commands their place in the order.
class ClockHost {
 public:
  ClockHost(const Roster& roster, const ServiceFactory& factory);

  bool Wants(const std::string& channel) const {
    return stepper_.Wants(channel);
  }
  std::string WantedPattern() const { return stepper_.WantedPattern(); }

  /// Everything the clock publishes in `tick`: commands first, then what the
  /// service does with `inputs` (messages of the tick before) and with them.
  /// Commands too short for a header, or that nobody takes, are refused.
  std::vector<Message> Tick(int32_t tick, std::vector<Message> inputs,
                            std::vector<Command> commands);

  /// True if the service wanted the run to end with this tick.
  bool IsLast(int32_t tick) const {
    return stepper_.end_tick() && tick >= *stepper_.end_tick();
  }
  int64_t num_refused() const { return num_refused_; }

 private:
  Stepper stepper_;
  std::unique_ptr<Service> service_;
  std::map<std::string, int32_t> next_seq_;
  std::vector<Command> waiting_;  // for the world to begin
  int64_t num_refused_ = 0;
};

}  // namespace cell
