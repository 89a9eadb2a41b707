#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/message.h"

namespace cell {

/// One event of an LCM log file.
struct LogEvent {
  int64_t number = 0;
  int64_t utime = 0;
  std::string channel;
  Bytes bytes;
  int64_t offset = 0;  ///< [bytes] where it begins in the file, if read
};

/// Writes the format of lcm-logger, readable by every LCM tool.
class EventLogWriter {
 public:
  /// @throws std::runtime_error naming the file if it cannot be created.
  explicit EventLogWriter(const std::filesystem::path& path);

  /// @throws std::runtime_error naming the file, also if no LCM log can hold
  /// such an event.
  void Write(int64_t utime, const std::string& channel, const Bytes& bytes);
  /// Hands all that was written to the system: it survives the process.
  /// @throws std::runtime_error naming the file, e.g. when the disk is full.
  void Flush();
  /// The last call. Reports errors found by the close. @throws as Flush().
  void Close();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Closer> file_;
  int64_t next_number_ = 0;
};

/// Reads LCM logs, damaged ones too: skips to the next whole event and reports
/// what it skipped (stock readers stop silently).
class EventLogReader {
 public:
  struct CorruptRange {
    int64_t offset = 0;  ///< [bytes] where the damage begins
    int64_t length = 0;  ///< [bytes] skipped: no whole event begins there
  };

  /// @throws std::runtime_error naming the file if it cannot be opened.
  explicit EventLogReader(const std::filesystem::path& path);

  /// The next whole event; nothing at the end of what has been written so far.
  std::optional<LogEvent> Next();

  /// Says that the log will not grow: an event that is cut off is damage then,
  /// not one that is still to come.
  void Finish() { is_finished_ = true; }
  const std::vector<CorruptRange>& corrupt_ranges() const {
    return corrupt_ranges_;
  }

 private:
  enum class Parse { kEvent, kMoreNeeded, kDamaged };
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  Parse ParseAt(size_t position, LogEvent* event, size_t* size) const;
  bool HasSyncAt(size_t position) const;
  bool HasEventsBetween(size_t begin, size_t end) const;
  bool HasSyncBetween(size_t begin, size_t end) const;
  bool IsPlausible(size_t position, size_t size) const;
  bool ReadMore(size_t event_size);
  void SkipToNextSync();

  std::unique_ptr<std::FILE, Close> file_;
  Bytes buffer_;
  size_t position_ = 0;  // in buffer_
  int64_t offset_ = 0;   // of buffer_ in the file
  bool is_finished_ = false;
  std::vector<CorruptRange> corrupt_ranges_;
};

}  // namespace cell
