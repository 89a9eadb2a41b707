#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "common/bus/event_log.h"
#include "common/bus/message.h"

namespace cell::cli {

/// An event of a log without its payload.
struct LogEntry {
  size_t file = 0;        ///< of LogIndex::files
  int64_t offset = 0;     ///< [bytes] in the file
  int64_t size = 0;       ///< [bytes] of the whole event
  int64_t number = 0;     ///< that the log gives it
  int64_t utime = 0;      ///< time of arrival by the log
  bool is_short = false;  ///< holds no header: not a message of the cell
  int64_t type_hash = 0;  ///< LCM's fingerprint of the message type
  bool is_tick = false;   ///< by its channel or its type: one may be damaged
  Message message;        ///< with bytes if is_tick
};

/// Everything in a log, or in several that one run was cut into, by place.
struct LogIndex {
  struct CorruptRange {
    size_t file = 0;
    int64_t offset = 0;
    int64_t length = 0;  ///< [bytes] in which no whole event begins
  };
  std::vector<std::filesystem::path> files;
  std::vector<LogEntry> entries;  ///< in the order of files and places
  std::vector<CorruptRange> corrupt_ranges;
};

/// @throws std::runtime_error naming the file if it cannot be opened or holds
/// no event at all.
LogIndex ReadLogIndex(const std::vector<std::filesystem::path>& logs);

/// Reads the logs once more and hands over the payload of each entry.
void ReadPayloads(
    const LogIndex& index,
    const std::function<void(size_t entry, const Bytes& bytes)>& handler);

}  // namespace cell::cli
