#include "common/bus/message.h"

#include <xxhash.h>

#include <bit>
#include <cstring>
#include <tuple>
#include <utility>

namespace cell {
namespace {

template <class T>
T ReadBigEndian(const Bytes& bytes, size_t offset) {
  T value = 0;
  for (size_t i = 0; i < sizeof(T); ++i) {
    value = static_cast<T>((value << 8) | bytes[offset + i]);
  }
  return value;
}

void WriteBigEndian(uint32_t value, size_t offset, Bytes& bytes) {
  for (size_t i = 0; i < 4; ++i) {
    bytes[offset + i] = static_cast<uint8_t>(value >> (24 - 8 * i));
  }
}

}  // namespace

bool OrderedBefore(const Message& a, const Message& b) {
  return std::tie(a.tick, a.channel, a.sender, a.seq) <
         std::tie(b.tick, b.channel, b.sender, b.seq);
}

int64_t DigestOf(const Bytes& bytes) {
  return std::bit_cast<int64_t>(XXH3_64bits(bytes.data(), bytes.size()));
}

WireHeader ReadWireHeader(const Bytes& bytes) {
  const auto i32 = [&](size_t offset) {
    return std::bit_cast<int32_t>(ReadBigEndian<uint32_t>(bytes, offset));
  };
  return {std::bit_cast<int64_t>(ReadBigEndian<uint64_t>(bytes, 8)), i32(16),
          i32(20), i32(24)};
}

void WriteIdentity(int32_t tick, int32_t sender, int32_t seq, Bytes& bytes) {
  WriteBigEndian(std::bit_cast<uint32_t>(tick), 16, bytes);
  WriteBigEndian(std::bit_cast<uint32_t>(sender), 20, bytes);
  WriteBigEndian(std::bit_cast<uint32_t>(seq), 24, bytes);
}

std::shared_ptr<const Message> MessageFromWire(std::string channel,
                                               Bytes bytes) {
  if (bytes.size() < kWireHeaderEnd) return nullptr;
  const WireHeader header = ReadWireHeader(bytes);
  auto message = std::make_shared<Message>();
  message->channel = std::move(channel);
  message->tick = header.tick;
  message->sender = header.sender;
  message->seq = header.seq;
  message->digest = DigestOf(bytes);
  message->bytes = std::make_shared<const Bytes>(std::move(bytes));
  return message;
}

}  // namespace cell
