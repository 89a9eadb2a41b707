#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "cell/tick_t.hpp"
#include "common/bus/message.h"

namespace cell {

/// A recorded run: one log, or several that a recorder's deaths have cut it
/// into, indexed by tick and checked against its manifests.
class RunLog {
 public:
  struct Tick {
    bool has_manifest = false;
    tick_t manifest{};
    std::vector<Message> messages;  ///< published in this tick, without TICK
  };

  /// Reads DIR/cell*.lcmlog. @throws std::runtime_error naming the file if
  /// there is none or it holds no TICK.
  static RunLog Load(const std::filesystem::path& run_dir);
  static RunLog Load(const std::vector<std::filesystem::path>& logs);

  const std::map<int32_t, Tick>& ticks() const { return ticks_; }

  /// Everything wrong with the logs, in plain words: damage, messages that a
  /// manifest names and that are missing or differ, breaks in the chain of
  /// TICKs. Empty for a whole log.
  const std::vector<std::string>& problems() const { return problems_; }

 private:
  void Read(const std::filesystem::path& log);
  void Check();

  std::map<int32_t, Tick> ticks_;
  std::vector<std::string> problems_;
};

/// The logs of a run folder, in the order in which they were written.
std::vector<std::filesystem::path> LogsOf(const std::filesystem::path& run_dir);
/// The parts NAME.00, NAME.01, ... into which lcm-logger has cut a recording,
/// in order. @throws std::runtime_error if they are of several recordings.
std::vector<std::filesystem::path> LoggerPartsOf(
    const std::filesystem::path& folder);
/// LogsOf(); where there are none, LoggerPartsOf().
/// @throws std::runtime_error naming the folder if there are none either.
std::vector<std::filesystem::path> RequireLogsOf(
    const std::filesystem::path& run_dir);

}  // namespace cell
