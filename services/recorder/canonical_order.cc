#include "services/recorder/canonical_order.h"

#include <algorithm>
#include <iterator>

namespace cell::recorder {

std::vector<Message> CanonicalOrder::TakeBefore(int32_t tick) {
  const auto split = std::stable_partition(
      messages_.begin(), messages_.end(),
      [tick](const Message& message) { return message.tick < tick; });
  std::vector<Message> taken(std::make_move_iterator(messages_.begin()),
                             std::make_move_iterator(split));
  messages_.erase(messages_.begin(), split);
  std::sort(taken.begin(), taken.end(), OrderedBefore);
  return taken;
}

}  // namespace cell::recorder
