#include "services/cell/episode_observer.h"

#include <algorithm>

#include "cell/episode_t.hpp"
#include "common/bus/bus.h"

namespace cell {
namespace {

template <class M>
void AppendDecoded(const Message& message, std::vector<M>* list) {
  if (auto decoded = Decode<M>(message)) list->push_back(std::move(*decoded));
}

}  // namespace

void EpisodeObserver::Put(const Message& message) {
  record_.last_utime =
      std::max(record_.last_utime, int64_t{message.tick} * kTickUs);
  if (message.channel == "ACTION") {
    AppendDecoded(message, &record_.actions);
  } else if (message.channel == "TRUTH_ACTIONS") {
    AppendDecoded(message, &record_.truth_actions);
  } else if (message.channel == "ALERT") {
    AppendDecoded(message, &record_.alerts);
  } else if (message.channel == "PLAN") {
    AppendDecoded(message, &record_.plans);
  } else if (message.channel == "KEY_FRAME") {
    if (const auto frame = Decode<key_frame_t>(message)) {
      record_.key_frame_utimes[frame->index] = frame->header.utime;
    }
  } else if (message.channel == "TRUTH_POSES") {
    if (auto poses = Decode<truth_poses_t>(message)) {
      record_.last_poses = std::move(*poses);
    }
  } else if (message.channel == "EPISODE") {
    const auto episode = Decode<episode_t>(message);
    if (!episode) return;
    if (episode->phase == episode_t::START) record_ = EpisodeRecord{};
    record_.has_ended = episode->phase == episode_t::END;
  }
}

}  // namespace cell
