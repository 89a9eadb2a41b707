#include "common/bus/follow_node.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/bus/manifest.h"

namespace cell {
namespace {

// There is no clock that asks for it.
constexpr int64_t kNonce = 1;

}  // namespace

FollowNode::FollowNode(const Roster& roster, const std::string& name,
                       const ServiceFactory& factory,
                       std::function<void(const Message&)> send)
    : name_(name),
      index_(roster.RequireIndexOf(name)),
      node_(roster, name, kNonce, factory,
            {.send_data =
                 [this, send = std::move(send)](const Message& message) {
                   sent_[message.tick].push_back(message);
                   send(message);
                 },
             .send_ack =
                 [](const ack_t&) {
                 }}) {}

void FollowNode::PutTick(tick_t tick) {
  if (!IsSound(tick.flows)) return;
  // The follower takes the recorded service's slot; a log that was begun later
  // does not say when that was taken.
  std::erase_if(tick.joined, [this](const joined_t& joined) {
    return joined.name == name_ && node_.has_joined();
  });
  for (joined_t& joined : tick.joined) {
    if (joined.name == name_) joined.nonce = kNonce;
  }
  const bool is_late_log = !node_.has_joined() && tick.header.tick > 0;
  if (is_late_log) {
    joined_t joined{};
    joined.name = name_;
    joined.nonce = kNonce;
    joined.sender = SenderOf(index_, 0);
    tick.joined.push_back(joined);
  }
  tick.num_joined = static_cast<int32_t>(tick.joined.size());
  std::vector<MessageId> own = MessagesIn(tick.flows);
  std::erase_if(own, [this](const MessageId& id) {
    return static_cast<size_t>(BaseOf(id.sender)) != index_;
  });
  recorded_[tick.header.tick - 1] = std::move(own);
  node_.PutTick(tick);
}

bool FollowNode::Advance() {
  if (!node_.Advance()) return false;
  Compare(node_.tick() - 1);
  return true;
}

void FollowNode::Compare(int32_t tick) {
  std::vector<Message> sent = std::move(sent_[tick]);
  const std::vector<MessageId>& recorded = recorded_[tick];
  std::sort(sent.begin(), sent.end(), OrderedBefore);
  const auto [ours, theirs] = std::mismatch(
      sent.begin(), sent.end(), recorded.begin(), recorded.end(),
      [](const Message& a, const MessageId& b) {
        return a.channel == b.channel && a.seq == b.seq && a.digest == b.digest;
      });
  num_equal_ += ours - sent.begin();
  if (!difference_ && (ours != sent.end() || theirs != recorded.end())) {
    difference_ =
        fmt::format("tick {}: {} differs from the log", tick,
                    ours != sent.end() ? ours->channel : theirs->channel);
  }
  sent_.erase(sent_.begin(), sent_.upper_bound(tick));
  recorded_.erase(recorded_.begin(), recorded_.upper_bound(tick));
}

}  // namespace cell
