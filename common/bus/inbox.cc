#include "common/bus/inbox.h"

#include <algorithm>
#include <utility>

namespace cell {
namespace {

// [bytes] of memory that a kept message takes, with its bookkeeping.
size_t WeightOf(const Message& message) {
  return message.bytes->size() + 256;
}

}  // namespace

void Inbox::Put(Message message) {
  if (num_bytes_ + WeightOf(message) > kMaxBytes) {
    ++num_unknown_senders_;
    return;
  }
  std::vector<Message>& duplicates =
      candidates_[{message.channel, message.sender, message.seq}];
  for (const Message& duplicate : duplicates) {
    if (duplicate.digest == message.digest) return;  // came again
  }
  num_bytes_ += WeightOf(message);
  duplicates.push_back(std::move(message));
}

std::optional<std::vector<Message>> Inbox::Pop(
    const std::vector<MessageId>& ids) {
  std::vector<std::pair<Id, const Message*>> found;
  for (const MessageId& id : ids) {
    const auto it = candidates_.find({id.channel, id.sender, id.seq});
    const Message* match = nullptr;
    if (it != candidates_.end()) {
      for (const Message& candidate : it->second) {
        if (candidate.digest == id.digest) match = &candidate;
      }
    }
    if (match == nullptr) {
      missing_ = id;
      is_corrupt_ = it != candidates_.end();
      return std::nullopt;
    }
    found.emplace_back(it->first, match);
  }
  missing_.reset();
  std::vector<Message> messages;
  for (const auto& [id, match] : found) messages.push_back(*match);
  for (const auto& [id, match] : found) {
    const auto it = candidates_.find(id);
    for (const Message& duplicate : it->second)
      num_bytes_ -= WeightOf(duplicate);
    num_unknown_senders_ += static_cast<int64_t>(it->second.size()) - 1;
    candidates_.erase(it);
  }
  return messages;
}

void Inbox::Purge(int32_t tick) {
  for (auto it = candidates_.begin(); it != candidates_.end();) {
    std::vector<Message>& duplicates = it->second;
    num_unknown_senders_ +=
        std::erase_if(duplicates, [&](const Message& message) {
          const bool is_old = message.tick < tick;
          if (is_old) num_bytes_ -= WeightOf(message);
          return is_old;
        });
    it = duplicates.empty() ? candidates_.erase(it) : std::next(it);
  }
}

}  // namespace cell
