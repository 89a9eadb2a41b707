#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cell/flow_t.hpp"
#include "cell/tick_t.hpp"
#include "common/bus/message.h"

namespace cell {

/// Identity of one message as a manifest names it.
struct MessageId {
  std::string channel;
  int32_t sender = 0;
  int32_t seq = 0;
  int64_t digest = 0;
};

/// "CHANNEL sender 2 seq 20"
std::string ToString(const MessageId& id);

/// What `messages` (of one tick) amount to, by (channel, sender).
std::vector<flow_t> FlowsOf(const std::vector<Message>& messages);

/// The messages that the flows name, of the channels that `wants` accepts; all
/// without it.
std::vector<MessageId> MessagesIn(
    const std::vector<flow_t>& flows,
    const std::function<bool(const std::string& channel)>& wants = {});

/// The part of a TICK that is the same in every run: without run id and nonces.
/// Its bytes are what logs keep and digests cover.
tick_t Canonical(tick_t tick);

/// The canonical TICK as a message.
Message TickMessage(const tick_t& tick);

/// True if counts fit and the flows ascend by (channel, sender); a decoded TICK
/// or ACK may still be forged.
bool IsSound(const std::vector<flow_t>& flows);

}  // namespace cell
