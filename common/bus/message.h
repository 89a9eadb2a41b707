#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cell {

using Bytes = std::vector<uint8_t>;

/// An encoded message and its identity on the bus.
struct Message {
  std::string channel;
  int32_t tick = 0;  ///< in which it was published
  int32_t sender = 0;
  int32_t seq = 0;  ///< per (channel, sender)
  int64_t digest = 0;
  std::shared_ptr<const Bytes> bytes;
};

/// Canonical order within a tick.
bool OrderedBefore(const Message& a, const Message& b);

/// XXH3-64 of the bytes.
int64_t DigestOf(const Bytes& bytes);

/// The identity at fixed offsets in the bytes of every message type
/// (fingerprint, then header_t), read without decoding.
struct WireHeader {
  int64_t utime = 0;
  int32_t tick = 0;
  int32_t sender = 0;
  int32_t seq = 0;
};
inline constexpr size_t kWireHeaderEnd = 28;

/// @pre bytes.size() >= kWireHeaderEnd
WireHeader ReadWireHeader(const Bytes& bytes);
/// Writes tick, sender and seq; utime stays. @pre as above.
void WriteIdentity(int32_t tick, int32_t sender, int32_t seq, Bytes& bytes);

/// The message on `channel` with these bytes, or nothing if they are too few
/// to hold a header.
std::shared_ptr<const Message> MessageFromWire(std::string channel,
                                               Bytes bytes);

/// The named channels; nothing: all there are.
using Channels = std::optional<std::vector<std::string>>;
inline constexpr std::nullopt_t kAllChannels = std::nullopt;

/// Channels of the protocol itself.
inline constexpr char kTickChannel[] = "TICK";
inline constexpr char kHelloChannel[] = "HELLO";
inline constexpr char kAckChannel[] = "ACK";
inline constexpr char kHealthChannel[] = "HEALTH";
inline constexpr char kStatusChannel[] = "STATUS";

}  // namespace cell
