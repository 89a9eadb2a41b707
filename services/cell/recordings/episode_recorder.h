#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "cell/episode_t.hpp"
#include "cell/truth_poses_t.hpp"
#include "common/bus/message.h"
#include "common/recordings/recording.h"
#include "common/task/task.h"

namespace cell::cli {

/// Makes the recording of one episode from the messages of a testbed: for each
/// TRACKS the TRUTH_POSES that it was made of, of the task's parts and hands;
/// the names that were said; and, for scorers, the TRUTH_ACTIONS.
class EpisodeRecorder {
 public:
  /// @param number  of the episode, from 1. @param build  that simulates it.
  EpisodeRecorder(const Task& task, int number, const std::string& build);

  /// Takes the messages in their order. Other channels are passed over.
  void Put(const Message& message);

  bool has_episode() const { return num_started_ >= number_; }
  /// The recording of what was put; no frames if nothing was.
  Recording Finish() const;

 private:
  void OnEpisode(const episode_t& message);
  void AddFrame(int64_t utime, const truth_poses_t& truth,
                Recording* recording) const;

  Recording head_;  // without frames
  int number_;
  int num_started_ = 0;
  int64_t start_utime_ = 0;
  std::map<std::string, size_t> index_;      // of bodies
  std::set<int64_t> track_utimes_;           // of the episode
  std::map<int64_t, truth_poses_t> truths_;  // of the episode, by utime
};

}  // namespace cell::cli
