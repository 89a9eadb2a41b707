#include "services/sec_builder/sec_builder.h"

#include "common/scene/track.h"
#include "common/task/task.h"

namespace cell::sec_builder {

SecBuilder::SecBuilder(Bus& bus, const Params& params)
    : bus_(bus),
      scene_objects_(params.scene_objects),
      extractor_params_(params.extractor),
      sensor_(params.scene_objects, params.parts, params.proximity),
      extractor_(params.scene_objects, params.extractor) {
  bus.Subscribe<episode_t>("EPISODE",
                           [this](const episode_t& m) { return OnEpisode(m); });
  bus.Subscribe<tracks_t>("TRACKS",
                          [this](const tracks_t& m) { return OnTracks(m); });
}

bool SecBuilder::OnEpisode(const episode_t& message) {
  const auto event = episode_.Update(message);
  if (event == EpisodeEvent::kBegins) {
    extractor_ = KeyFrameExtractor(scene_objects_, extractor_params_);
    last_utime_.reset();
    first_index_ = 0;
  }
  return event.has_value();
}

bool SecBuilder::OnTracks(const tracks_t& message) {
  const auto tracks = TracksFromMessage(message, scene_objects_);
  if (!tracks || (last_utime_ && tracks->utime <= *last_utime_)) return false;
  if (episode_.IsBefore(tracks->utime)) return true;
  last_utime_ = tracks->utime;
  // A life that begins within an episode has seen fewer key frames than ticks.
  if (!first_index_) first_index_ = bus_.tick();
  for (KeyFrame& frame : extractor_.Update(*tracks, sensor_.Measure(*tracks))) {
    frame.index += *first_index_;
    bus_.Publish("KEY_FRAME", KeyFrameToMessage(frame));
  }
  return true;
}

std::unique_ptr<Service> MakeSecBuilder(Bus& bus,
                                        const Deployment& deployment) {
  const Task task = LoadTask(deployment);
  SecBuilder::Params params{task.scene_objects, task.parts, {}, {}};
  const Config config = deployment.ForService("sec_builder");
  PairFilter::Params& pair = params.extractor.pair;
  pair.touch = config.Number("touch_mm", 0.01, 1000) * 1e-3;
  pair.release = config.Number("release_mm", 0.01, 1000) * 1e-3;
  if (pair.release < pair.touch) {
    config["release_mm"].Fail("must not be less than touch_mm");
  }
  pair.stick_out = pair.release - pair.touch;
  pair.confirm_frames = config.Integer("confirm_frames", 1, 100);
  params.extractor.merge_us =
      config.Integer("merge_ms", 0, 10'000) * int64_t{1000};
  params.extractor.absent_us =
      config.Integer("absent_ms", 1, 1'000'000) * int64_t{1000};
  config.Finish();
  params.proximity = {pair.touch / 2, 1.5 * pair.release};
  return std::make_unique<SecBuilder>(bus, params);
}

}  // namespace cell::sec_builder
