#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/clock.h"
#include "common/bus/clock_host.h"
#include "common/bus/roster.h"
#include "common/bus/stepper.h"

namespace cell {

/// All services of a cell in one process and thread, in virtual time: the same
/// messages, manifests and digests as the same services over LCM.
class SimBus {
 public:
  /// A service that does not answer from `death_tick` on; its next incarnation
  /// begins at `join_tick` >= death_tick.
  struct Outage {
    std::string service;
    int32_t death_tick = 0;
    int32_t join_tick = 0;
  };
  struct TimedCommand {
    int32_t tick = 0;
    Command command;
  };
  /// `factories` by service name, one for each of the roster's.
  /// @throws std::invalid_argument naming a service without factory, or an
  /// outage of the clock or of an unknown service.
  SimBus(const Roster& roster, std::map<std::string, ServiceFactory> factories,
         std::vector<Outage> outages = {},
         std::vector<TimedCommand> commands = {});

  /// For tests that decide while the cell runs; must lie in a later tick than
  /// the last one. @throws std::invalid_argument like the constructor, or if it
  /// is too late.
  void Schedule(const Outage& outage);
  void Schedule(const TimedCommand& command);

  /// Makes the next tick; false once the last one has been made.
  bool Step();

  const tick_t& last_tick() const { return last_tick_; }
  /// What its manifest names: the clock's messages of the last tick and the
  /// services' of the one before.
  const std::vector<Message>& last_messages() const { return last_messages_; }

 private:
  struct Slot {
    int32_t incarnation = -1;
    bool is_silent = false;  // in an outage
    int32_t join_tick = 0;
    std::unique_ptr<Stepper> stepper;  // before its service: outlives it
    std::unique_ptr<Service> service;
    std::vector<Message> pending;  // outputs of an activation that lasts
    int32_t until = -1;
  };

  void Add(const Outage& outage);
  void BeginOutagesAndIncarnations(int32_t tick);
  void NewIncarnation(size_t index, int32_t tick);
  void Handle(size_t index, const tick_t& tick,
              const std::vector<Message>& messages);
  ack_t NewAck(size_t index, int32_t tick) const;
  std::vector<Command> CommandsOf(int32_t tick);

  Roster roster_;
  std::map<std::string, ServiceFactory> factories_;
  std::vector<Outage> outages_;
  std::vector<TimedCommand> commands_;
  ClockHost host_;
  Clock clock_;
  std::vector<Slot> slots_;  // by roster index; the clock's own is unused
  std::vector<Message> published_;  // by services in the tick before
  tick_t last_tick_{};
  std::vector<Message> last_messages_;
};

}  // namespace cell
