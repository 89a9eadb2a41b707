#include "services/cell/scoring/contact_events.h"

#include <algorithm>
#include <map>

#include "services/sec_builder/proximity.h"

namespace cell::cli {

using namespace sec_builder;
namespace {

constexpr int kMinFrames = 2;  // a change that lasts fewer is none

bool IsOfHandsAlone(const ObjectPair& pair, const SceneObjects& objects) {
  return objects.IsHand(pair.first) && objects.IsHand(pair.second);
}

/// What a pair did in the last frames.
struct PairState {
  bool is_touch = false;
  int64_t changed_utime = 0;
  int num_changed = 0;  // frames in a row that show another state

  /// True if the state has just changed for good, at changed_utime.
  bool Update(int64_t utime, bool shows_touch) {
    if (shows_touch == is_touch) {
      num_changed = 0;
      return false;
    }
    if (num_changed == 0) changed_utime = utime;
    if (++num_changed < kMinFrames) return false;
    is_touch = shows_touch;
    num_changed = 0;
    return true;
  }
};

}  // namespace

std::vector<ContactEvent> TrueContactEvents(TrackStream& true_tracks,
                                            const SceneObjects& scene_objects,
                                            const PartTable& parts,
                                            double touch) {
  const ProximitySensor sensor(scene_objects, parts, {touch / 10, 2 * touch});
  std::map<ObjectPair, PairState> states;
  std::vector<ContactEvent> events;
  while (const auto tracks = true_tracks.Next()) {
    for (const auto& [pair, proximity] : sensor.Measure(*tracks)) {
      if (IsOfHandsAlone(pair, scene_objects)) continue;
      const bool is_touch = proximity.distance < touch;
      const auto [state, is_first] =
          states.try_emplace(pair, PairState{is_touch});
      if (is_first || !state->second.Update(tracks->utime, is_touch)) continue;
      events.push_back({state->second.changed_utime, pair, is_touch});
    }
  }
  std::ranges::stable_sort(events, {}, &ContactEvent::utime);
  return events;
}

std::vector<ContactEvent> ContactEventsOf(const std::vector<KeyFrame>& frames,
                                          const SceneObjects& scene_objects) {
  std::vector<ContactEvent> events;
  for (size_t i = 1; i < frames.size(); ++i) {
    for (const auto& [pair, relation] : frames[i].relations) {
      const auto& [a, b] = pair;
      const bool is_touch = Touch(frames[i].relations, a, b);
      if (is_touch == Touch(frames[i - 1].relations, a, b)) continue;
      if (IsOfHandsAlone(pair, scene_objects)) continue;
      events.push_back({frames[i].utime, pair, is_touch});
    }
  }
  return events;
}

}  // namespace cell::cli
