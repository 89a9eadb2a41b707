#include "services/cell/scoring/episode_observer.h"

#include <algorithm>

#include "common/bus/bus.h"
#include "common/bus/decode.h"

namespace cell::cli {
namespace {

template <class M>
void AppendDecoded(const Message& message, std::vector<M>* list) {
  if (auto decoded = Decode<M>(message)) list->push_back(std::move(*decoded));
}

}  // namespace

void EpisodeObserver::Put(const Message& message) {
  EpisodeRecord& record = records_.back();
  record.last_utime =
      std::max(record.last_utime, int64_t{message.tick} * kTickUs);
  if (message.channel == "ACTION") {
    AppendDecoded(message, &record.actions);
  } else if (message.channel == "TRUTH_ACTIONS") {
    AppendDecoded(message, &record.truth_actions);
  } else if (message.channel == "ALERT") {
    AppendDecoded(message, &record.alerts);
  } else if (message.channel == "PLAN") {
    AppendDecoded(message, &record.plans);
  } else if (message.channel == "SKILL_REQUEST") {
    AppendDecoded(message, &record.requests);
  } else if (message.channel == "SKILL_RESULT") {
    AppendDecoded(message, &record.results);
  } else if (message.channel == "EXECUTION") {
    if (auto execution = Decode<execution_t>(message)) {
      record.execution = std::move(*execution);
    }
  } else if (message.channel == "KEY_FRAME") {
    if (const auto frame = Decode<key_frame_t>(message)) {
      record.key_frame_utimes[frame->index] = frame->header.utime;
      record.key_frame_ticks[frame->index] = frame->header.tick;
    }
  } else if (message.channel == "TRUTH_POSES") {
    // Poses between two episodes belong to neither.
    auto poses = Decode<truth_poses_t>(message);
    if (poses && !record.has_ended) record.pose_history.Put(*std::move(poses));
  } else if (message.channel == "EPISODE") {
    const auto episode = Decode<episode_t>(message);
    if (!episode) return;
    if (episode->phase == episode_t::START) {
      if (has_begun_) records_.emplace_back();
      records_.back() = EpisodeRecord{};
      records_.back().episode = *episode;
      has_begun_ = true;
    }
    records_.back().has_ended = episode->phase == episode_t::END;
  }
}

}  // namespace cell::cli
