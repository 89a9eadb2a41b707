#pragma once

#include <string>
#include <vector>

#include "services/cell/scoring/episode_observer.h"
#include "services/cell/scoring/true_progress.h"

namespace cell::cli {

/// Whether a person was told what had to be said, and nothing else (section
/// VII-C). After an action that leaves no way to the goal an error is due,
/// after one that makes the way longer a warning, after any other nothing; by
/// TrueProgress.
struct AlarmScore {
  int num_actions = 0;         ///< truth
  int num_warnings_due = 0;    ///< truth: the way has become longer
  int num_warned = 0;          ///< by a warning in time
  int num_errors_due = 0;      ///< truth: a dead end
  int num_called_errors = 0;   ///< by an error in time
  int num_missed = 0;          ///< due, but neither warned nor called an error
  int num_of_wrong_level = 0;  ///< due, but of the other level
  int num_late = 0;            ///< later than one key frame
  int num_false = 0;           ///< alarms that nothing has made due
  /// From the key frame that shows the action to that of the alarm, the most.
  int most_key_frames = 0;
  double most_seconds = 0;           ///< from letting go to the alarm
  std::vector<std::string> remarks;  ///< what was not as it should be

  bool is_faultless() const { return remarks.empty(); }
};

/// @param progress  before the first action of the episode
AlarmScore ScoreAlarms(const EpisodeRecord& record, TrueProgress progress);

}  // namespace cell::cli
