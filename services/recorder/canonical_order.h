#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/bus/message.h"

namespace cell::recorder {

/// Brings the messages of a run into the canonical order of logs: by tick,
/// channel, sender, seq. A tick is complete when the next TICK has come, with
/// the services' messages of the tick before. Pure.
class CanonicalOrder {
 public:
  void Put(Message message) { messages_.push_back(std::move(message)); }

  /// All messages of ticks before `tick`, in order.
  std::vector<Message> TakeBefore(int32_t tick);

 private:
  std::vector<Message> messages_;
};

}  // namespace cell::recorder
