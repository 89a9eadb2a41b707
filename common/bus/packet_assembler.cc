#include "common/bus/packet_assembler.h"

#include <algorithm>
#include <utility>

#include "common/bus/lcm_packet.h"

namespace cell {
namespace {

constexpr size_t kLongestName = 63;  // as LCM

uint32_t ReadWord(std::span<const uint8_t> bytes, size_t offset, size_t size) {
  uint32_t value = 0;
  for (size_t i = 0; i < size; ++i) value = value << 8 | bytes[offset + i];
  return value;
}

/// Takes the name and its NUL off the front; nothing if there is no NUL.
std::optional<std::string> TakeChannel(std::span<const uint8_t>& rest) {
  const auto head = rest.first(std::min(rest.size(), kLongestName + 1));
  const auto nul = std::find(head.begin(), head.end(), uint8_t{0});
  if (nul == head.end()) return std::nullopt;
  std::string channel(head.begin(), nul);
  rest = rest.subspan(channel.size() + 1);
  return channel;
}

}  // namespace

std::optional<PacketAssembler::Arrival> PacketAssembler::Put(
    uint64_t sender, std::span<const uint8_t> packet) {
  if (packet.size() < kShortHeaderSize) return std::nullopt;
  const uint32_t magic = ReadWord(packet, 0, 4);
  if (magic == kShortMagic) return PutShort(packet);
  if (magic == kFragmentMagic && packet.size() > kFragmentHeaderSize) {
    return PutFragment(sender, packet);
  }
  return std::nullopt;
}

std::optional<PacketAssembler::Arrival> PacketAssembler::PutShort(
    std::span<const uint8_t> packet) const {
  auto rest = packet.subspan(kShortHeaderSize);
  auto channel = TakeChannel(rest);
  if (!channel || !wants_(*channel)) return std::nullopt;
  return Arrival{*std::move(channel), Bytes(rest.begin(), rest.end())};
}

std::optional<PacketAssembler::Arrival> PacketAssembler::PutFragment(
    uint64_t sender, std::span<const uint8_t> packet) {
  const uint32_t sequence = ReadWord(packet, 4, 4);
  const uint32_t size = ReadWord(packet, 8, 4);
  const uint32_t offset = ReadWord(packet, 12, 4);
  const auto number = static_cast<uint16_t>(ReadWord(packet, 16, 2));
  const auto count = static_cast<uint16_t>(ReadWord(packet, 18, 2));
  auto rest = packet.subspan(kFragmentHeaderSize);
  if (number == 0) Begin(sender, {{}, sequence, size, count, 0}, rest);
  const auto it = partials_.find(sender);
  if (it == partials_.end()) return std::nullopt;
  Partial& partial = it->second;
  Bytes& bytes = partial.message.bytes;
  const bool fits = sequence == partial.sequence && size == partial.size &&
                    count == partial.num_fragments &&
                    number == partial.next_fragment && offset == bytes.size() &&
                    rest.size() <= size - bytes.size();
  if (!fits) {
    Forget(sender);
    return std::nullopt;
  }
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  if (++partial.next_fragment < count) return std::nullopt;
  Arrival whole = std::move(partial.message);
  Forget(sender);
  if (whole.bytes.size() != size) return std::nullopt;
  return whole;
}

void PacketAssembler::Begin(uint64_t sender, Partial partial,
                            std::span<const uint8_t>& rest) {
  Forget(sender);
  auto channel = TakeChannel(rest);
  if (!channel || !wants_(*channel) || partials_.size() == kMaxSenders ||
      partial.size > kMaxPartialBytes - num_partial_bytes_) {
    return;
  }
  partial.message.channel = *std::move(channel);
  num_partial_bytes_ += partial.size;
  partials_.emplace(sender, std::move(partial));
}

void PacketAssembler::Forget(uint64_t sender) {
  const auto it = partials_.find(sender);
  if (it == partials_.end()) return;
  num_partial_bytes_ -= it->second.size;
  partials_.erase(it);
}

}  // namespace cell
