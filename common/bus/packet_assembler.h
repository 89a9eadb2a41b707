#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "common/bus/message.h"

namespace cell {

/// LCM's messages from its UDP packets, pure: a short message is one packet
/// (magic, sequence number, channel, NUL, data); a long one is cut into
/// fragments, of which only the first names the channel. Whatever lengths and
/// offsets a packet claims, nothing outside it is read.
class PacketAssembler {
 public:
  struct Arrival {
    std::string channel;
    Bytes bytes;
  };
  using Wants = std::function<bool(const std::string& channel)>;

  /// Messages on channels that `wants` refuses are not assembled.
  explicit PacketAssembler(Wants wants) : wants_(std::move(wants)) {}

  /// The message that the packet completes, if any. Fragments of one sender's
  /// message arrive in order or not at all: one that is out of order, doubled
  /// or of another message ends it.
  std::optional<Arrival> Put(uint64_t sender, std::span<const uint8_t> packet);

 private:
  /// As LCM; and of all senders together.
  static constexpr size_t kMaxSenders = 1000;
  static constexpr size_t kMaxPartialBytes = 64u << 20;

  struct Partial {
    Arrival message;
    uint32_t sequence = 0;
    uint32_t size = 0;
    uint16_t num_fragments = 0;
    uint16_t next_fragment = 0;
  };

  std::optional<Arrival> PutShort(std::span<const uint8_t> packet) const;
  std::optional<Arrival> PutFragment(uint64_t sender,
                                     std::span<const uint8_t> packet);
  void Begin(uint64_t sender, Partial partial, std::span<const uint8_t>& rest);
  void Forget(uint64_t sender);

  Wants wants_;
  std::map<uint64_t, Partial> partials_;  // by sender
  size_t num_partial_bytes_ = 0;          // that their messages will have
};

}  // namespace cell
