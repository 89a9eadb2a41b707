#include "services/sec_builder/sec_builder.h"

#include <fmt/format.h>

#include <vector>

#include "cell/alert_t.hpp"
#include "common/scene/relation_layers.h"
#include "common/scene/segment_name.h"
#include "common/scene/track.h"
#include "common/task/task.h"

namespace cell::sec_builder {

SecBuilder::SecBuilder(Bus& bus, const KeyFrameBuilder::Params& params)
    : bus_(bus), scene_objects_(params.scene_objects), builder_(params) {
  bus.Subscribe<episode_t>("EPISODE",
                           [this](const episode_t& m) { return OnEpisode(m); });
  bus.Subscribe<tracks_t>("TRACKS",
                          [this](const tracks_t& m) { return OnTracks(m); });
}

bool SecBuilder::OnEpisode(const episode_t& message) {
  const auto event = episode_.Update(message);
  if (event == EpisodeEvent::kBegins) {
    builder_.Reset(static_cast<uint64_t>(message.seed));
    last_utime_.reset();
    first_index_ = 0;
    told_.clear();
  }
  return event.has_value();
}

bool SecBuilder::OnTracks(const tracks_t& message) {
  const auto tracks = TracksFromMessage(message, scene_objects_);
  if (!tracks || (last_utime_ && tracks->utime <= *last_utime_)) return false;
  if (episode_.IsBefore(tracks->utime)) return true;
  last_utime_ = tracks->utime;
  TellWhatIsLeftOut(*tracks);
  // Indices go on after a restart: an episode has fewer key frames than ticks.
  if (!first_index_) first_index_ = bus_.tick();
  std::vector<KeyFrame> frames = builder_.Update(*tracks);
  const std::vector<RelationLayers>& layers = builder_.layers();
  size_t next = 0;
  for (KeyFrame& frame : frames) {
    frame.index += *first_index_;
    bus_.Publish("KEY_FRAME", KeyFrameToMessage(frame));
    if (next == layers.size()) continue;  // none is on
    RelationLayers of_frame = layers[next++];
    of_frame.key_frame = frame.index;
    bus_.Publish("RELATION_LAYERS", LayersToMessage(of_frame, frame.utime));
  }
  return true;
}

void SecBuilder::TellWhatIsLeftOut(const Tracks& tracks) {
  for (const std::string& name : tracks.left_out) {
    if (told_.size() >= kMaxSegments || !told_.insert(name).second) continue;
    alert_t alert{};
    alert.header.utime = tracks.utime;
    alert.level = alert_t::WARNING;
    alert.cause = alert_t::BAD_INPUT;
    alert.text = fmt::format(
        "TRACKS: '{}' is no part or hand of the task, and has no surface "
        "points: it takes no part in relations",
        name);
    bus_.Publish("ALERT", alert);
  }
}

std::unique_ptr<Service> MakeSecBuilder(Bus& bus,
                                        const Deployment& deployment) {
  return std::make_unique<SecBuilder>(
      bus, KeyFrameBuilder::Params::Load(deployment, LoadTask(deployment)));
}

}  // namespace cell::sec_builder
