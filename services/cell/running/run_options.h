#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "services/cell/running/run_folder.h"

namespace CLI {
class App;
}

namespace cell::cli {

/// The episodes of a cell that starts from nothing, if no others are named.
inline constexpr char kTaughtEpisodes[] = "taught+taught+taught";

/// The common options of `cell demo` and `cell sim`.
struct RunOptions {
  std::string deploy_dir;
  std::string demonstration;
  uint64_t seed = 1;
  std::string out;
  bool has_cameras = false;
  bool is_from_nothing = false;
  bool learns = false;  ///< whatever recognizer.yaml and planner.yaml say
  bool does_not_learn = false;  ///< the same
  bool is_confirmed = false;
  std::string library;
  std::string variant;
  bool is_hash = false;
  bool is_verbose = false;
  std::vector<std::string> help_steps;

  void AddTo(CLI::App& command);
  /// @param kind begins the folder's name if none is given.
  RunFolder CreateFolder(const std::string& kind) const;
};

}  // namespace cell::cli
