#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "common/bus/arrivals.h"
#include "common/bus/clock_host.h"
#include "common/bus/command_gate.h"
#include "common/bus/stepper.h"

namespace cell {

inline constexpr char kStepChannel[] = "STEP";

/// A service of a live cell: takes messages as they arrive; once a tick it is
/// activated with all of them and sends its STEP and its outputs. It waits for
/// no other service. Pure.
class LiveNode {
 public:
  using Send = std::function<void(const Message&)>;

  /// `incarnation` counts the starts of the service from 0; must never repeat.
  LiveNode(const Roster& roster, const std::string& name, int32_t incarnation,
           const ServiceFactory& factory, Send send);

  bool Wants(const std::string& channel) const {
    return stepper_.Wants(channel);
  }
  Channels WantedChannels() const { return stepper_.WantedChannels(); }

  void Put(Message message);
  /// For the service at the roster's head, that gives commands their order.
  void Put(Command command);

  /// Runs the activation of `tick`, later than any before.
  void Step(int32_t tick);

  int32_t sender() const { return stepper_.params().sender; }
  /// Messages that reached an activation later than in lockstep, by channel.
  const std::map<std::string, int64_t>& num_late() const { return num_late_; }
  const Arrivals& arrivals() const { return arrivals_; }

 private:
  void PublishStep(int32_t tick, const std::vector<Message>& inputs);

  Send send_;
  Stepper stepper_;
  std::unique_ptr<Service> service_;
  CommandGate gate_;
  Arrivals arrivals_;
  std::vector<Message> inbox_;
  size_t num_bytes_ = 0;
  std::vector<Command> commands_;
  int32_t next_step_ = 0;
  bool is_journaled_;
  std::map<std::string, int64_t> num_late_;
};

/// How many ticks later than in lockstep `message` reaches an activation in
/// `tick`: there, messages of the roster's head arrive within their tick, those
/// of others in the next one.
int32_t TicksLate(const Message& message, int32_t tick);

/// Parameters of a service in a live cell: no latency is simulated.
Stepper::Params LiveStepperParams(const Roster& roster, size_t index,
                                  int32_t sender);

}  // namespace cell
