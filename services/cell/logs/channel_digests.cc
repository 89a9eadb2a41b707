#include "services/cell/logs/channel_digests.h"

#include <fmt/format.h>

#include <array>
#include <bit>

#include "common/bus/message.h"
#include "common/text/printable.h"

namespace cell::cli {

void ChannelDigests::Put(const tick_t& manifest) {
  for (const flow_t& flow : manifest.flows) {
    uint64_t& chain = digests_[flow.channel];
    for (const int64_t digest : flow.digests) {
      const auto bytes = std::bit_cast<std::array<uint8_t, 16>>(
          std::array{chain, std::bit_cast<uint64_t>(digest)});
      chain =
          std::bit_cast<uint64_t>(DigestOf(Bytes(bytes.begin(), bytes.end())));
    }
  }
}

std::vector<std::string> ChannelDigests::Lines() const {
  std::vector<std::string> lines;
  for (const auto& [channel, digest] : digests_) {
    lines.push_back(fmt::format("{} {:016x}", Printable(channel), digest));
  }
  return lines;
}

}  // namespace cell::cli
