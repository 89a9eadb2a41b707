#pragma once

#include <filesystem>
#include <string>

#include "common/planning/planner.h"

namespace cell::cli {

/// A file that keeps a search for a plan, so that it can go on after an
/// interruption or with a larger budget. Storage adapter.
class SearchFile {
 public:
  /// @param question    all that the search depends on: another one is refused
  /// @param is_resumed  go on from what the file holds, if it is there
  /// @throws std::runtime_error naming a file that is there but not to be used
  SearchFile(std::filesystem::path path, const std::string& question,
             bool is_resumed);

  /// @throws std::runtime_error naming the file if it is damaged, or holds
  /// another search or something else
  void Restore(planning::Planner* planner) const;
  /// Replaces the file at once. @throws std::runtime_error naming it
  void Save(const planning::Planner& planner) const;

  /// For Planner::Find(): saves whenever the expansions have grown by half,
  /// at the end, and when a signal stops the search.
  planning::Planner::Watch SaveWhile(const planning::Planner* planner);
  /// @throws std::runtime_error that says how to go on if a signal has stopped
  /// the search
  void ThrowIfStopped() const;

 private:
  std::filesystem::path path_;
  std::string title_;  ///< first line of the file
  bool is_resumed_;
  int64_t next_save_;
  bool is_stopped_ = false;
};

}  // namespace cell::cli
