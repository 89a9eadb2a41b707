#include "services/cell/logs/sequence_gaps.h"

#include <fmt/format.h>

#include <algorithm>

namespace cell::cli {
namespace {

/// More in one row are reported in one line.
constexpr int64_t kMaxLines = 1000;

// Those from `from` up to, but without, `to`, which lie in ticks a to b.
void Name(const std::string& channel, int32_t sender, int32_t from, int32_t to,
          int32_t a, int32_t b, std::vector<LogFinding>* findings) {
  const std::string ticks =
      a == b ? fmt::format("tick {}", a) : fmt::format("ticks {} to {}", a, b);
  if (int64_t{to} - from > kMaxLines) {
    findings->push_back(
        {"", -1, 0, -1, channel,
         fmt::format("sender {} seq {} to {} are lost with the TICKs that "
                     "named them ({})",
                     sender, from, to - 1, ticks)});
    return;
  }
  for (int32_t seq = from; seq < to; ++seq) {
    findings->push_back(
        {"", -1, 0, -1, channel,
         fmt::format("sender {} seq {} is lost with the TICK that named it "
                     "({})",
                     sender, seq, ticks)});
  }
}

int32_t NamedIn(int32_t sender, int32_t tick) {
  return sender == 0 ? tick : tick + 1;
}

}  // namespace

void SequenceGaps::Put(const std::string& channel, int32_t sender, int32_t seq,
                       int32_t tick) {
  if (seq >= 0) flows_[{channel, sender}].push_back({seq, tick});
}

bool SequenceGaps::IsDeadIn(int32_t sender, int32_t tick) const {
  const auto death = deaths_.find(sender);
  return death != deaths_.end() && death->second <= tick;
}

std::vector<LogFinding> SequenceGaps::Find() const {
  std::vector<LogFinding> findings;
  for (const auto& [flow, unsorted] : flows_) {
    const auto& [channel, sender] = flow;
    std::vector<Place> places = unsorted;
    std::stable_sort(places.begin(), places.end());
    const auto birth = births_.find(sender);
    Place before =
        birth == births_.end() ? places.front() : Place{-1, birth->second};
    for (const Place& place : places) {
      if (place.seq > before.seq + 1) {
        Name(channel, sender, before.seq + 1, place.seq,
             std::min(before.tick, place.tick), place.tick, &findings);
      }
      before = place;
    }
  }
  return findings;
}

std::vector<std::string> SequenceGaps::EndsIn(int32_t first,
                                              int32_t last) const {
  std::vector<std::string> ends;
  for (const auto& [flow, places] : flows_) {
    const auto& [channel, sender] = flow;
    const Place& end = *std::max_element(places.begin(), places.end());
    if (NamedIn(sender, end.tick) > last || IsDeadIn(sender, first - 1))
      continue;
    ends.push_back(
        fmt::format("{} sender {} seq {}", channel, sender, end.seq));
  }
  return ends;
}

std::vector<std::string> SequenceGaps::BeginningsUpTo(int32_t last) const {
  std::vector<std::string> beginnings;
  for (const auto& [flow, places] : flows_) {
    const auto& [channel, sender] = flow;
    const Place& begin = *std::min_element(places.begin(), places.end());
    if (begin.seq == 0 || births_.contains(sender) ||
        NamedIn(sender, begin.tick) <= last) {
      continue;
    }
    beginnings.push_back(
        fmt::format("{} sender {} seq {}", channel, sender, begin.seq));
  }
  return beginnings;
}

}  // namespace cell::cli
