#include "services/cell/logs/log_index.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "cell/tick_t.hpp"

namespace cell::cli {
namespace {

constexpr int64_t kEventHeaderSize = 28;

int64_t TypeHashOf(const Bytes& bytes) {
  uint64_t hash = 0;
  for (size_t i = 0; i < 8; ++i) hash = hash << 8 | bytes[i];
  return static_cast<int64_t>(hash);
}

LogEntry EntryOf(size_t file, LogEvent event) {
  LogEntry entry;
  entry.file = file;
  entry.offset = event.offset;
  entry.size = kEventHeaderSize +
               static_cast<int64_t>(event.channel.size() + event.bytes.size());
  entry.number = event.number;
  entry.utime = event.utime;
  if (event.bytes.size() < kWireHeaderEnd) {
    entry.is_short = true;
    entry.message.channel = std::move(event.channel);
    return entry;
  }
  entry.type_hash = TypeHashOf(event.bytes);
  entry.message =
      *MessageFromWire(std::move(event.channel), std::move(event.bytes));
  entry.is_tick = entry.message.channel == kTickChannel ||
                  entry.type_hash == tick_t::getHash();
  if (!entry.is_tick) entry.message.bytes = nullptr;
  return entry;
}

}  // namespace

LogIndex ReadLogIndex(const std::vector<std::filesystem::path>& logs) {
  LogIndex index;
  index.files = logs;
  for (size_t file = 0; file < logs.size(); ++file) {
    const size_t num_before = index.entries.size();
    EventLogReader reader(logs[file]);
    reader.Finish();
    while (auto event = reader.Next()) {
      index.entries.push_back(EntryOf(file, std::move(*event)));
    }
    if (index.entries.size() == num_before) {
      throw std::runtime_error(fmt::format(
          "{}: is not an LCM log: no event in its {} bytes",
          logs[file].string(), std::filesystem::file_size(logs[file])));
    }
    for (const auto& range : reader.corrupt_ranges()) {
      index.corrupt_ranges.push_back({file, range.offset, range.length});
    }
  }
  return index;
}

void ReadPayloads(
    const LogIndex& index,
    const std::function<void(size_t entry, const Bytes& bytes)>& handler) {
  size_t entry = 0;
  for (const auto& log : index.files) {
    EventLogReader reader(log);
    reader.Finish();
    while (const auto event = reader.Next()) handler(entry++, event->bytes);
  }
}

}  // namespace cell::cli
