#include "common/bus/event_log.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <unordered_set>

namespace cell {
namespace {

constexpr uint32_t kSync = 0xEDA1DA01;
constexpr std::array<uint8_t, 4> kSyncBytes = {0xED, 0xA1, 0xDA, 0x01};
constexpr size_t kHeaderSize = 28;
// What LCM's own reader takes: names of less than 1000 characters, and lengths
// of data that are positive as int32.
constexpr uint64_t kMaxChannel = 999;
constexpr uint64_t kMaxData = INT32_MAX;

std::string Error(const std::filesystem::path& path, const char* what) {
  return path.string() + ": " + what + ": " + std::strerror(errno);
}

void Append(uint64_t value, size_t size, Bytes* bytes) {
  for (size_t i = size; i-- > 0;) {
    bytes->push_back(static_cast<uint8_t>(value >> (8 * i)));
  }
}

uint64_t Read(const Bytes& bytes, size_t position, size_t size) {
  uint64_t value = 0;
  for (size_t i = 0; i < size; ++i) value = value << 8 | bytes[position + i];
  return value;
}

}  // namespace

EventLogWriter::EventLogWriter(const std::filesystem::path& path)
    : path_(path), file_(std::fopen(path.c_str(), "wb")) {
  if (!file_) throw std::runtime_error(Error(path, "cannot be created"));
}

void EventLogWriter::Write(int64_t utime, const std::string& channel,
                           const Bytes& bytes) {
  if (channel.empty() || channel.size() > kMaxChannel ||
      bytes.size() > kMaxData) {
    throw std::runtime_error(fmt::format(
        "{}: an LCM log cannot hold an event of {} bytes on a channel of {} "
        "characters: at most {} bytes, and 1 to {} characters",
        path_.string(), bytes.size(), channel.size(), kMaxData, kMaxChannel));
  }
  Bytes header;
  header.reserve(kHeaderSize + channel.size());
  Append(kSync, 4, &header);
  Append(std::bit_cast<uint64_t>(next_number_++), 8, &header);
  Append(std::bit_cast<uint64_t>(utime), 8, &header);
  Append(channel.size(), 4, &header);
  Append(bytes.size(), 4, &header);
  header.insert(header.end(), channel.begin(), channel.end());
  const bool is_written =
      std::fwrite(header.data(), 1, header.size(), file_.get()) ==
          header.size() &&
      std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size();
  if (!is_written) throw std::runtime_error(Error(path_, "cannot be written"));
}

void EventLogWriter::Flush() {
  if (std::fflush(file_.get()) != 0) {
    throw std::runtime_error(Error(path_, "cannot be written"));
  }
}

void EventLogWriter::Close() {
  Flush();
  if (std::fclose(file_.release()) != 0) {
    throw std::runtime_error(Error(path_, "cannot be written"));
  }
}

EventLogReader::EventLogReader(const std::filesystem::path& path)
    : file_(std::fopen(path.c_str(), "rb")) {
  if (!file_) throw std::runtime_error(Error(path, "cannot be opened"));
}

bool EventLogReader::HasSyncAt(size_t position) const {
  const size_t num = std::min(buffer_.size() - position, kSyncBytes.size());
  return std::equal(kSyncBytes.begin(),
                    kSyncBytes.begin() + static_cast<std::ptrdiff_t>(num),
                    buffer_.begin() + static_cast<std::ptrdiff_t>(position));
}

// True if a row of whole events begins somewhere after `begin` and goes on to
// exactly `end`.
bool EventLogReader::HasEventsBetween(size_t begin, size_t end) const {
  const auto at = [this](size_t i) {
    return buffer_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  std::unordered_set<size_t> dead_ends;
  auto sync = at(begin + 1);
  while ((sync = std::search(sync, at(end), kSyncBytes.begin(),
                             kSyncBytes.end())) != at(end)) {
    auto position = static_cast<size_t>(sync - buffer_.begin());
    while (position + kHeaderSize < end && HasSyncAt(position)) {
      const uint64_t channel_size = Read(buffer_, position + 20, 4);
      const uint64_t data_size = Read(buffer_, position + 24, 4);
      if (channel_size == 0 || channel_size > kMaxChannel ||
          !dead_ends.insert(position).second) {
        break;
      }
      position += kHeaderSize + channel_size + data_size;
    }
    if (position == end) return true;
    ++sync;
  }
  return false;
}

bool EventLogReader::HasSyncBetween(size_t begin, size_t end) const {
  const auto at = [this](size_t i) {
    return buffer_.begin() + static_cast<std::ptrdiff_t>(i);
  };
  return begin < end && std::search(at(begin), at(end), kSyncBytes.begin(),
                                    kSyncBytes.end()) != at(end);
}

// Without reading all of a long event: that would take as much memory as a
// damaged length says.
bool EventLogReader::IsPlausible(size_t position, size_t size) const {
  std::array<uint8_t, 5> end{};  // the last byte, and the next sync word
  const auto offset = offset_ + static_cast<int64_t>(position + size) - 1;
  const ssize_t got =
      pread(fileno(file_.get()), end.data(), end.size(), offset);
  if (got < 0) return true;  // a pipe
  if (got == 0) return !is_finished_;
  return std::equal(end.begin() + 1, end.begin() + got, kSyncBytes.begin()) ||
         !HasSyncBetween(position + 4, buffer_.size());
}

// A damaged length may swallow neighbours. So an event is not taken for whole
// if it holds a sync word and nothing follows it, or if it ends where a row of
// events within it does. (A message may hold a sync word by chance.)
EventLogReader::Parse EventLogReader::ParseAt(size_t position, LogEvent* event,
                                              size_t* size) const {
  const size_t left = buffer_.size() - position;
  if (!HasSyncAt(position)) return Parse::kDamaged;
  if (left < kHeaderSize) return Parse::kMoreNeeded;
  const uint64_t channel_size = Read(buffer_, position + 20, 4);
  const uint64_t data_size = Read(buffer_, position + 24, 4);
  if (channel_size == 0 || channel_size > kMaxChannel || data_size > kMaxData) {
    return Parse::kDamaged;
  }
  *size = kHeaderSize + channel_size + data_size;
  if (left < *size) {
    return IsPlausible(position, *size) ? Parse::kMoreNeeded : Parse::kDamaged;
  }
  if (!HasSyncAt(position + *size)) {
    if (HasSyncBetween(position + 4, position + std::min(*size + 3, left))) {
      return Parse::kDamaged;
    }
  } else if (HasEventsBetween(position, position + *size)) {
    return Parse::kDamaged;
  }
  event->offset = offset_ + static_cast<int64_t>(position);
  event->number = std::bit_cast<int64_t>(Read(buffer_, position + 4, 8));
  event->utime = std::bit_cast<int64_t>(Read(buffer_, position + 12, 8));
  const auto data =
      buffer_.begin() + static_cast<std::ptrdiff_t>(position + kHeaderSize);
  const auto split = data + static_cast<std::ptrdiff_t>(channel_size);
  event->channel.assign(data, split);
  event->bytes.assign(split, split + static_cast<std::ptrdiff_t>(data_size));
  return Parse::kEvent;
}

bool EventLogReader::ReadMore(size_t event_size) {
  buffer_.erase(buffer_.begin(),
                buffer_.begin() + static_cast<std::ptrdiff_t>(position_));
  offset_ += static_cast<int64_t>(position_);
  position_ = 0;
  const size_t old_size = buffer_.size();
  // With the sync word behind it; a log that grows may never get so far.
  const size_t wanted = is_finished_ ? event_size + kSyncBytes.size() : 0;
  const size_t chunk =
      std::max(size_t{1} << 20, wanted - std::min(wanted, old_size));
  buffer_.resize(old_size + chunk);
  std::clearerr(file_.get());
  const size_t got =
      std::fread(buffer_.data() + old_size, 1, chunk, file_.get());
  buffer_.resize(old_size + got);
  return got > 0;
}

std::optional<LogEvent> EventLogReader::Next() {
  while (true) {
    LogEvent event;
    size_t size = 0;
    const Parse parse = position_ < buffer_.size()
                            ? ParseAt(position_, &event, &size)
                            : Parse::kMoreNeeded;
    if (parse == Parse::kEvent) {
      position_ += size;
      return event;
    }
    if (parse == Parse::kMoreNeeded) {
      if (ReadMore(size)) continue;
      if (!is_finished_ || position_ == buffer_.size()) return std::nullopt;
    }
    SkipToNextSync();
  }
}

void EventLogReader::SkipToNextSync() {
  const auto from = buffer_.begin() + static_cast<std::ptrdiff_t>(position_);
  const auto next = std::search(from + 1, buffer_.end(), kSyncBytes.begin(),
                                kSyncBytes.end());
  size_t position = static_cast<size_t>(next - buffer_.begin());
  if (next == buffer_.end() && !is_finished_) {
    // A sync word may straddle the end of what has been read.
    position = std::max(position_ + 1, buffer_.size() - 3);
  }
  const int64_t begin = offset_ + static_cast<int64_t>(position_);
  const auto length = static_cast<int64_t>(position - position_);
  if (!corrupt_ranges_.empty() &&
      corrupt_ranges_.back().offset + corrupt_ranges_.back().length == begin) {
    corrupt_ranges_.back().length += length;
  } else {
    corrupt_ranges_.push_back({begin, length});
  }
  position_ = position;
}

}  // namespace cell
