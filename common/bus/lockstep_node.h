#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cell/ack_t.hpp"
#include "cell/hello_t.hpp"
#include "cell/tick_t.hpp"
#include "common/bus/clock_host.h"
#include "common/bus/inbox.h"
#include "common/bus/stepper.h"

namespace cell {

/// The lockstep protocol as a service sees it, pure: TICKs and data in any
/// order in, strictly ordered activations, data and ACKs out.
class LockstepNode {
 public:
  /// How a node sends its outputs.
  struct Link {
    std::function<void(const Message&)> send_data;
    std::function<void(const ack_t&)> send_ack;
  };

  /// `nonce` distinguishes this incarnation from others; must not repeat.
  LockstepNode(const Roster& roster, const std::string& name, int64_t nonce,
               const ServiceFactory& factory, Link link);

  hello_t Hello() const;
  bool has_joined() const { return next_tick_ >= 0; }
  bool Wants(const std::string& channel) const {
    return stepper_.Wants(channel);
  }
  Channels WantedChannels() const { return stepper_.WantedChannels(); }

  void PutData(Message message);

  /// @throws BusError if another cell or another incarnation of this name is
  /// heard.
  void PutTick(tick_t tick);

  /// Handles the next tick if all it needs is there; false if not.
  bool Advance();

  /// True once the last tick has been handled.
  bool is_done() const { return is_done_; }

  /// Why Advance() waits for data, or nothing while it waits for a TICK.
  std::optional<std::string> MissingData() const;

  int32_t tick() const { return next_tick_ - 1; }
  int64_t num_repeats() const { return num_repeats_; }
  int64_t num_unknown_senders() const { return inbox_.num_unknown_senders(); }
  int32_t sender() const { return sender_; }

 private:
  ack_t NewAck(int32_t tick) const;
  void SendAck(ack_t ack);
  std::vector<MessageId> NeededBy(const tick_t& tick) const;
  void Handle(const tick_t& tick, std::vector<Message> inputs);
  void FinishActivation();

  std::string name_;
  int64_t nonce_;
  Link link_;
  Stepper stepper_;
  std::unique_ptr<Service> service_;

  Inbox inbox_;
  std::map<int32_t, tick_t> ticks_;  // not handled yet
  std::vector<Message> outputs_;     // of an activation that lasts
  std::optional<ack_t> last_ack_;
  int64_t run_ = 0;
  int32_t sender_ = 0;
  int32_t join_tick_ = -1;
  int32_t next_tick_ = -1;
  bool is_done_ = false;
  int64_t num_repeats_ = 0;
};

}  // namespace cell
