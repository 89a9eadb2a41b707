#include "common/bus/episode_gate.h"

#include <utility>

namespace cell {

std::optional<EpisodeEvent> EpisodeGate::Update(const episode_t& message) {
  switch (message.phase) {
    case episode_t::START:
      id_ = message.id;
      start_utime_ = message.header.utime;
      return EpisodeEvent::kBegins;
    case episode_t::RUNNING:
      if (std::exchange(id_, message.id) == message.id) {
        return EpisodeEvent::kRuns;
      }
      start_utime_ = 0;
      return EpisodeEvent::kJoins;
    case episode_t::END:
      return EpisodeEvent::kEnds;
    default:
      return std::nullopt;
  }
}

}  // namespace cell
