#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/event_log.h"
#include "common/bus/message.h"
#include "common/config/config.h"

namespace cell::recorder {

/// Storage adapter of the recorder of a live cell: cell-0001.lcmlog and so on
/// in the run folder, a new file when one is large enough, the oldest ones
/// removed. It leaves room on the disk for others, and outlives a full one.
class RotatingLog {
 public:
  struct Params {
    int64_t file_bytes = 256 << 20;   ///< a new file after this size
    int64_t total_bytes = 8ll << 30;  ///< of all files of the folder
    int64_t free_bytes = 512 << 20;   ///< it stops with less left on the disk
  };
  /// Of recorder.yaml. @throws ConfigError naming file:key.
  static Params ParamsFromConfig(const Config& config);

  RotatingLog(std::filesystem::path run_dir, const Params& params);

  /// Writes the messages, with their ticks as stamps, and hands them to the
  /// system. Nothing, or why they are not kept, naming the folder; the next
  /// call tries again.
  std::optional<std::string> Append(const std::vector<Message>& messages);

 private:
  std::optional<std::string> LackOfRoom() const;
  void Open();
  void RemoveOldest() const;

  std::filesystem::path run_dir_;
  Params params_;
  std::optional<EventLogWriter> writer_;
  int64_t num_bytes_ = 0;  // of the file that is written
};

}  // namespace cell::recorder
