#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "common/bus/manifest.h"
#include "common/bus/message.h"

namespace cell {

/// Messages that came before their TICK: keeps every candidate of an id,
/// because a forged one may carry a true one's; the manifest's digest tells
/// them apart.
class Inbox {
 public:
  void Put(Message message);

  /// Removes and returns the named messages; nullopt while one is missing,
  /// which missing() then names.
  std::optional<std::vector<Message>> Pop(const std::vector<MessageId>& ids);
  const std::optional<MessageId>& missing() const { return missing_; }
  /// True if the missing message came with other bytes than announced.
  bool is_corrupt() const { return is_corrupt_; }

  /// Forgets what no manifest can name any more: messages of ticks before
  /// `tick`. Counts them as unknown senders.
  void Purge(int32_t tick);

  /// Datagrams that no manifest named, or for which there was no room.
  int64_t num_unknown_senders() const { return num_unknown_senders_; }

 private:
  /// Enough for any honest tick; a forger cannot make it grow further.
  static constexpr size_t kMaxBytes = 64u << 20;

  using Id = std::tuple<std::string, int32_t, int32_t>;
  std::map<Id, std::vector<Message>> candidates_;
  std::optional<MessageId> missing_;
  bool is_corrupt_ = false;
  size_t num_bytes_ = 0;
  int64_t num_unknown_senders_ = 0;
};

}  // namespace cell
