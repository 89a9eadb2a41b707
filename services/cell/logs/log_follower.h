#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "common/bus/event_log.h"
#include "common/bus/message.h"

namespace cell::cli {

/// Reads a run's logs while they are written, one after the other. Storage
/// adapter.
class LogFollower {
 public:
  explicit LogFollower(std::filesystem::path run_dir)
      : run_dir_(std::move(run_dir)) {}

  /// The next message; nothing if no more has been written yet.
  std::optional<Message> Next();

 private:
  bool OpenNext();

  std::filesystem::path run_dir_;
  size_t num_opened_ = 0;
  std::optional<EventLogReader> reader_;
};

}  // namespace cell::cli
