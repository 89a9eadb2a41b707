#pragma once

#include <vector>

#include "services/cell/scoring/episode_observer.h"

namespace cell::cli {

/// How well the cell understood what a person did, against ground truth.
struct EpisodeScore {
  int num_steps = 0;              ///< truth: parts placed where they belong
  int num_steps_recognised = 0;   ///< FORWARD, right part and arguments
  int num_take_backs = 0;         ///< truth: placed parts taken back
  int num_take_backs_named = 0;   ///< REVERSED, right part and site
  int num_take_backs_warned = 0;  ///< exactly one warning each, no error
  int num_moves = 0;              ///< truth: moved from nowhere to nowhere
  int num_moves_named = 0;        ///< right part, UNKNOWN or tipped
  int num_mistakes = 0;           ///< truth: planted
  int num_mistakes_caught = 0;    ///< right alert within one key frame
  int num_invented = 0;           ///< recognised, but not done
  int num_false_alarms = 0;       ///< warnings and errors without a cause
  bool is_goal_reached = false;   ///< by the last plan

  friend bool operator==(const EpisodeScore&, const EpisodeScore&) = default;
};

EpisodeScore Score(const EpisodeRecord& record);

}  // namespace cell::cli
