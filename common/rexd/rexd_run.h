#pragma once

#include <optional>
#include <vector>

#include "common/rexd/frozen_score.h"
#include "common/rexd/rexd.h"
#include "common/rexd/teacher.h"

namespace cell::rexd {

/// What happened in an episode. Demonstrations and explorations count as
/// actions.
struct EpisodeCounts {
  int num_actions = 0;
  int num_demonstrations = 0;
  int num_explorations = 0;
  bool is_goal_reached = false;
  bool is_dead_end = false;  ///< ended where the goal cannot be reached
  /// The true rule of the action that led from a state with a way to the goal
  /// to one without, an index of RexdTask::truth: the kind of the dead end.
  std::optional<int> fatal_rule;
  bool is_fall_demonstrated = false;  ///< the teacher did that action
};

struct RunParams {
  RexD::Params learner;
  PlanningTeacher::Params teacher;
  /// Of every action of the robot.
  double success = 1;
  int num_episodes = 4;
  /// After so many actions an episode has failed.
  int max_actions = 100;
  uint64_t seed = 1;
};

/// Learns a task from nothing, episode after episode.
/// @param frozen  if not null, how good the rules are that were learned
std::vector<EpisodeCounts> RunRexd(const RexdTask& task,
                                   const RunParams& params,
                                   FrozenScore* frozen = nullptr);

/// Learns several tasks of one world from nothing, `num_episodes` episodes of
/// each, one after the other: what was learned in one is known in the next.
/// @return the episodes of each task
/// @throws std::invalid_argument if the tasks' worlds differ, or if there is
///     none
std::vector<std::vector<EpisodeCounts>> RunRexdInTurn(
    const std::vector<RexdTask>& tasks, const RunParams& params);

}  // namespace cell::rexd
