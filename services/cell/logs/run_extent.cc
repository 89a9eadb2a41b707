#include "services/cell/logs/run_extent.h"

#include <algorithm>

#include "common/bus/bus.h"
#include "services/cell/logs/channel_types.h"

namespace cell::cli {

RunExtent::RunExtent(const LogIndex& index,
                     const std::map<int32_t, ManifestLink>& manifests,
                     bool is_canonical)
    : index_(&index), is_canonical_(is_canonical) {
  if (manifests.empty()) return;
  begin_ = first_tick_ = manifests.begin()->first;
  end_ = last_tick_ = manifests.rbegin()->first;
  is_whole_end_ = manifests.rbegin()->second.tick.is_last != 0;
  first_place_ = index.entries.size();
  for (const auto& [tick, link] : manifests) {
    for (const flow_t& flow : link.tick.flows) {
      flows_.emplace(flow.channel, flow.sender);
    }
    if (!link.entry) continue;
    first_place_ = std::min(first_place_, *link.entry);
    last_place_ = std::max(last_place_, *link.entry);
  }
  for (size_t i = 0; i < index.entries.size(); ++i) {
    if (!IsTrusted(i)) continue;
    const int32_t tick = index.entries[i].message.tick;
    // A recording that begins within a tick holds no more than a part of it.
    const bool is_part = !is_canonical && tick > 0;
    if (i < first_place_) begin_ = std::min(begin_, is_part ? tick + 1 : tick);
    if (i > last_place_ && !is_whole_end_) end_ = std::max(end_, tick);
  }
}

bool RunExtent::Contains(size_t entry, int32_t named_in) const {
  if (index_->entries[entry].message.tick < begin_) return false;
  if (named_in < first_tick_) return entry < first_place_ && IsTrusted(entry);
  if (named_in <= last_tick_) return true;
  return !is_whole_end_ && (named_in <= last_tick_ + 2 ||
                            (entry > last_place_ && IsTrusted(entry)));
}

bool RunExtent::IsTrusted(size_t entry) const {
  const LogEntry& at = index_->entries[entry];
  const Message& message = at.message;
  if (at.is_short || at.is_tick || message.tick < 0) return false;
  if (is_canonical_ && at.utime != int64_t{message.tick} * kTickUs)
    return false;
  const auto type = TypeOfChannel(message.channel);
  return flows_.contains({message.channel, message.sender}) ||
         (type && type->hash == at.type_hash);
}

}  // namespace cell::cli
