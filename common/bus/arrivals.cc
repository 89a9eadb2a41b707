#include "common/bus/arrivals.h"

#include "common/bus/roster.h"

namespace cell {

bool Arrivals::Accept(const Message& message) {
  const auto index = static_cast<size_t>(BaseOf(message.sender));
  const auto key = std::pair(message.channel, index);
  const auto it = flows_.find(key);
  if (message.sender < 0 || message.seq < 0 || index >= num_services_ ||
      (it == flows_.end() && flows_.size() >= kMaxFlows)) {
    ++num_unknown_senders_;
    return false;
  }
  if (it == flows_.end()) {
    flows_[key] = {.sender = message.sender, .seq = message.seq};
    return true;
  }
  return Follows(message, &it->second);
}

bool Arrivals::Follows(const Message& message, Flow* flow) {
  const int64_t jump = int64_t{message.seq} - flow->seq;
  const bool is_near =
      message.sender == flow->sender && jump >= -kMaxJump && jump <= kMaxJump;
  if (is_near && jump <= 0) {
    if (flow->skipped.erase(message.seq) == 0) {
      ++num_repeated_;
      return false;
    }
    --num_lost_[message.channel];
    return true;
  }
  if (is_near) {
    for (int32_t seq = flow->seq + 1; seq < message.seq; ++seq) {
      flow->skipped.insert(seq);
      ++num_lost_[message.channel];
    }
    flow->seq = message.seq;
    flow->skipped.erase(flow->skipped.begin(),
                        flow->skipped.lower_bound(message.seq - kMaxJump));
    return true;
  }
  const bool is_new_incarnation =
      message.sender > flow->sender && message.seq == 0;
  const bool is_confirmed =
      flow->doubtful == std::pair(message.sender, message.seq - 1);
  if (!is_new_incarnation && !is_confirmed) {
    flow->doubtful = {message.sender, message.seq};
    ++num_unknown_senders_;
    return false;
  }
  *flow = {.sender = message.sender, .seq = message.seq};
  return true;
}

}  // namespace cell
