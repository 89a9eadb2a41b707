#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cell/alert_t.hpp"
#include "cell/asked_skill_t.hpp"
#include "cell/episode_t.hpp"
#include "cell/execution_t.hpp"
#include "cell/key_frame_t.hpp"
#include "cell/plan_t.hpp"
#include "cell/predicates_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "cell/skill_result_t.hpp"
#include "cell/truth_action_t.hpp"
#include "common/bus/message.h"
#include "services/cell/scoring/pose_history.h"

namespace cell::cli {

/// What an episode came to, for scorers and summaries: collected from all its
/// messages. Reads ground truth, so no service may use it.
struct EpisodeRecord {
  episode_t episode{};  ///< as it was started
  std::vector<recognised_action_t> actions;
  std::vector<truth_action_t> truth_actions;
  std::vector<alert_t> alerts;
  std::vector<plan_t> plans;
  std::map<int64_t, int64_t> key_frame_utimes;  ///< by index
  std::map<int64_t, int32_t> key_frame_ticks;   ///< of publication, by index
  std::vector<asked_skill_t> requests;
  std::vector<skill_result_t> results;
  std::optional<execution_t> execution;  ///< the last
  PoseHistory pose_history;
  int64_t last_utime = 0;
  bool has_ended = false;  ///< EPISODE END was received
};

class EpisodeObserver {
 public:
  /// Messages in canonical order. Those that do not decode are passed over.
  void Put(const Message& message);
  /// Of the last episode.
  const EpisodeRecord& record() const { return records_.back(); }
  /// Of every episode, at least one.
  const std::vector<EpisodeRecord>& records() const { return records_; }

 private:
  std::vector<EpisodeRecord> records_{1};
  bool has_begun_ = false;
};

}  // namespace cell::cli
