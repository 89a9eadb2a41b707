#include "common/bus/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "common/bus/bus.h"

namespace cell {

std::string ToString(const MessageId& id) {
  return fmt::format("{} sender {} seq {}", id.channel, id.sender, id.seq);
}

std::vector<flow_t> FlowsOf(const std::vector<Message>& messages) {
  std::map<std::pair<std::string, int32_t>, flow_t> flows;
  for (const Message& message : messages) {
    flow_t& flow = flows[{message.channel, message.sender}];
    if (flow.digests.empty()) {
      flow.channel = message.channel;
      flow.sender = message.sender;
      flow.first_seq = message.seq;
    }
    flow.digests.push_back(message.digest);
    flow.count = static_cast<int32_t>(flow.digests.size());
  }
  std::vector<flow_t> sorted;
  for (auto& entry : flows) sorted.push_back(std::move(entry.second));
  return sorted;
}

std::vector<MessageId> MessagesIn(
    const std::vector<flow_t>& flows,
    const std::function<bool(const std::string& channel)>& wants) {
  std::vector<MessageId> ids;
  for (const flow_t& flow : flows) {
    if (wants && !wants(flow.channel)) continue;
    for (int32_t i = 0; i < flow.count; ++i) {
      ids.push_back({flow.channel, flow.sender, flow.first_seq + i,
                     flow.digests[static_cast<size_t>(i)]});
    }
  }
  return ids;
}

tick_t Canonical(tick_t tick) {
  tick.run = 0;
  for (joined_t& joined : tick.joined) joined.nonce = 0;
  return tick;
}

Message TickMessage(const tick_t& tick) {
  Bytes bytes = Bus::Encode(Canonical(tick));
  const int64_t digest = DigestOf(bytes);
  return {kTickChannel,
          tick.header.tick,
          tick.header.sender,
          tick.header.seq,
          digest,
          std::make_shared<const Bytes>(std::move(bytes))};
}

bool IsSound(const std::vector<flow_t>& flows) {
  const auto is_before = [](const flow_t& a, const flow_t& b) {
    return std::tie(a.channel, a.sender) < std::tie(b.channel, b.sender);
  };
  for (size_t i = 0; i < flows.size(); ++i) {
    const flow_t& flow = flows[i];
    if (flow.count <= 0 || flow.first_seq < 0 || flow.sender < 0 ||
        flow.first_seq > INT32_MAX - flow.count || flow.channel.empty() ||
        (i > 0 && !is_before(flows[i - 1], flow))) {
      return false;
    }
  }
  return true;
}

}  // namespace cell
