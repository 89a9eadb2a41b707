#include "services/cell/logs/foreign_types.h"

#include <fmt/format.h>

#include <bit>
#include <map>
#include <string>
#include <utility>

#include "services/cell/logs/channel_types.h"

namespace cell::cli {

std::vector<LogFinding> FindForeignTypes(const LogIndex& index,
                                         bool has_manifests) {
  std::map<std::pair<std::string, int64_t>, int64_t> num_foreign;
  std::map<std::string, int64_t> num_own;
  for (const LogEntry& entry : index.entries) {
    const std::string& channel = entry.message.channel;
    const auto type = TypeOfChannel(channel);
    if (entry.is_short || !type) continue;
    if (type->hash == entry.type_hash) {
      ++num_own[channel];
    } else {
      ++num_foreign[{channel, entry.type_hash}];
    }
  }
  std::vector<LogFinding> findings;
  for (const auto& [key, num] : num_foreign) {
    const auto& [channel, hash] = key;
    if (has_manifests && num_own[channel] > 0) continue;
    const ChannelType type = *TypeOfChannel(channel);
    findings.push_back(
        {"", -1, 0, -1, channel,
         fmt::format("{} messages have the type hash {:016x}; this program's "
                     "{} has {:016x}. They were recorded with other message "
                     "types: the texts are in the run folder's lcmtypes/",
                     num, std::bit_cast<uint64_t>(hash), type.name,
                     std::bit_cast<uint64_t>(type.hash))});
  }
  return findings;
}

}  // namespace cell::cli
