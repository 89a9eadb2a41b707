#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace cell::cli {

struct ChannelType {
  std::string name;  ///< e.g. "tracks_t"
  int64_t hash = 0;  ///< LCM's fingerprint
};

/// The message type of a channel as lcmtypes/README.md has it; nothing for a
/// channel that is not the cell's.
std::optional<ChannelType> TypeOfChannel(const std::string& channel);

}  // namespace cell::cli
