#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "cell/tracks_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/episode_gate.h"
#include "common/config/deployment.h"
#include "common/scene/scene_objects.h"
#include "services/sec_builder/key_frame_builder.h"

namespace cell::sec_builder {

/// TRACKS -> KEY_FRAME: the semantic event chain of an episode (section V-B).
/// RELATION_LAYERS follows each, if its settings ask for it. An ALERT names
/// once what cannot take part in relations, because nobody knows its extent.
class SecBuilder final : public Service {
 public:
  /// `bus` must outlive this object.
  SecBuilder(Bus& bus, const KeyFrameBuilder::Params& params);

 private:
  bool OnEpisode(const episode_t& message);
  bool OnTracks(const tracks_t& message);
  void TellWhatIsLeftOut(const Tracks& tracks);

  Bus& bus_;
  EpisodeGate episode_;
  SceneObjects scene_objects_;
  KeyFrameBuilder builder_;             // of the episode
  std::optional<int64_t> last_utime_;   // of its tracks
  std::optional<int64_t> first_index_;  // of its key frames
  std::set<std::string> told_;          // what is left out in it
};

std::unique_ptr<Service> MakeSecBuilder(Bus& bus, const Deployment& deployment);

}  // namespace cell::sec_builder
