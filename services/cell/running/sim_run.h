#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "common/bus/sim_bus.h"

namespace cell::cli {

/// Runs to the end, and shows every message in canonical order.
inline void RunToEnd(SimBus& bus,
                     const std::function<void(const Message&)>& visit) {
  while (bus.Step()) {
    std::vector<Message> messages = bus.last_messages();
    std::sort(messages.begin(), messages.end(), OrderedBefore);
    std::ranges::for_each(messages, visit);
  }
}

}  // namespace cell::cli
