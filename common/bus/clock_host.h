#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/bus/command_gate.h"
#include "common/bus/roster.h"
#include "common/bus/stepper.h"

namespace cell {

/// Builds a service on a bus. Called once per incarnation.
using ServiceFactory = std::function<std::unique_ptr<Service>(Bus&)>;

/// Runs the service that owns time, tick by tick, and gives operators'
/// commands their place in the order.
class ClockHost {
 public:
  ClockHost(const Roster& roster, const ServiceFactory& factory);

  bool Wants(const std::string& channel) const {
    return stepper_.Wants(channel);
  }
  Channels WantedChannels() const { return stepper_.WantedChannels(); }

  /// Everything the clock publishes in `tick`: commands first, then what the
  /// service does with `inputs` (messages of the tick before) and with them.
  std::vector<Message> Tick(int32_t tick, std::vector<Message> inputs,
                            std::vector<Command> commands);

  /// True if the service wanted the run to end with this tick.
  bool IsLast(int32_t tick) const {
    return stepper_.end_tick() && tick >= *stepper_.end_tick();
  }
  int64_t num_refused() const { return gate_.num_refused(); }

 private:
  Stepper stepper_;
  std::unique_ptr<Service> service_;
  CommandGate gate_;
  std::vector<Command> waiting_;  // for the world to begin
};

}  // namespace cell
