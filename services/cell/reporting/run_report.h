#pragma once

#include <filesystem>
#include <string>

#include "services/cell/logs/channel_digests.h"
#include "services/cell/logs/log_follower.h"
#include "services/cell/reporting/narrator.h"
#include "services/cell/running/progress.h"
#include "services/cell/running/run_folder.h"
#include "services/cell/running/run_options.h"
#include "services/cell/scoring/episode_observer.h"

namespace cell::cli {

/// Prints what happens in a run, from its log as it grows, and a summary. With
/// --hash it prints only the digests of the channels.
class RunReport {
 public:
  RunReport(const RunFolder& run, const RunOptions& options);

  /// Prints what has been written since the last call.
  void Follow();
  /// Prints a message of the launcher.
  void Print(const std::string& line);
  /// Prints the summary, and draws the end of each episode into the run folder.
  /// @return 0 if the last episode came to its end, and no episode waited for a
  /// person who was not there.
  int Finish();

 private:
  std::string DrawPicture(const EpisodeRecord& record,
                          const std::string& name) const;

  const RunFolder& run_;
  bool is_hash_;
  LogFollower follower_;
  Narrator narrator_;
  EpisodeObserver observer_;
  ChannelDigests digests_;
  Progress progress_;
  int32_t tick_ = 0;
};

}  // namespace cell::cli
