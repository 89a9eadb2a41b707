#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "common/bus/event_log.h"
#include "common/bus/message.h"

namespace cell::recorder {

/// Creates cell-0001.lcmlog in `run_dir`, empty, with the number after the
/// highest there; no other caller gets the same.
/// @throws std::runtime_error naming the file if it cannot be created.
std::filesystem::path ClaimLogName(const std::filesystem::path& run_dir);

/// Storage adapter of the recorder: cell-0001.lcmlog in the run folder, the
/// next free number for each start. Without a folder it keeps nothing (replay).
class LogStore {
 public:
  /// @throws std::runtime_error naming the file if it cannot be created.
  explicit LogStore(const std::filesystem::path& run_dir);

  /// Writes the messages and hands them to the system: a death of this process
  /// loses none of them. @throws std::runtime_error, e.g. when the disk is
  /// full.
  void Append(const std::vector<Message>& messages);

 private:
  std::optional<EventLogWriter> writer_;
};

}  // namespace cell::recorder
