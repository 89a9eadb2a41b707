#include "services/cell/logs/log_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <utility>

#include "common/bus/bus.h"
#include "services/cell/logs/log_sequence.h"

namespace cell::cli {
namespace {

// The events lost in a corrupt range, by the numbers of its neighbours.
std::string NumbersLostAt(const LogIndex& index,
                          const LogIndex::CorruptRange& range) {
  const auto& entries = index.entries;
  const auto next = std::partition_point(
      entries.begin(), entries.end(), [&](const LogEntry& entry) {
        return std::tie(entry.file, entry.offset) <
               std::tie(range.file, range.offset);
      });
  const bool has_before =
      next != entries.begin() && (next - 1)->file == range.file;
  const int64_t from = has_before ? (next - 1)->number + 1 : 0;
  if (next == entries.end() || next->file != range.file) {
    return fmt::format("; event {} and what may follow are lost", from);
  }
  if (next->number == from) return "";  // the event before is cut short
  if (next->number < from) {
    return fmt::format("; the numbers restart at {}", next->number);
  }
  if (next->number == from + 1) return fmt::format("; event {} is lost", from);
  return fmt::format("; events {} to {} are lost", from, next->number - 1);
}

}  // namespace

LogFinding FindingAt(const LogIndex& index, size_t entry, std::string text) {
  const LogEntry& at = index.entries[entry];
  return {index.files[at.file].filename().string(),
          at.offset,
          at.size,
          at.message.tick,
          at.message.channel,
          std::move(text)};
}

std::vector<LogFinding> FindOddFrames(const LogIndex& index,
                                      bool is_canonical) {
  std::vector<LogFinding> findings;
  for (const auto& range : index.corrupt_ranges) {
    findings.push_back(
        {index.files[range.file].filename().string(), range.offset,
         range.length, -1, "",
         "no whole event begins here" + NumbersLostAt(index, range)});
  }
  std::ranges::move(FindOddNumbers(index, is_canonical),
                    std::back_inserter(findings));
  if (!is_canonical) return findings;
  for (size_t i = 0; i < index.entries.size(); ++i) {
    const LogEntry& entry = index.entries[i];
    const int64_t utime = int64_t{entry.message.tick} * kTickUs;
    if (!entry.is_short && entry.utime != utime) {
      findings.push_back(
          FindingAt(index, i,
                    fmt::format("its stamp is {} us, its tick's is {} us",
                                entry.utime, utime)));
    }
  }
  return findings;
}

}  // namespace cell::cli
