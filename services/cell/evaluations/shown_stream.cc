#include "services/cell/evaluations/shown_stream.h"

#include <fmt/format.h>

#include <utility>

#include "common/recordings/noisy_tracks.h"
#include "services/cell/evaluations/pose_noise.h"
#include "services/cell/recordings/joined_tracks.h"
#include "services/cell/recordings/recorded_tracks.h"
#include "services/sec_builder/key_frame_builder.h"

namespace cell::cli {
namespace {

/// Opens one recording after the other, and remembers what they say is true.
class Demonstrations {
 public:
  Demonstrations(const ShownStreamParams& params, const Task& task,
                 const std::function<void(const std::string&)>& show)
      : params_(params), task_(task), show_(show) {}

  std::unique_ptr<TrackStream> Next() {
    const size_t i = truths_.size();
    const size_t num_all = params_.demonstrations.size();
    if (i == num_all) return nullptr;
    show_(fmt::format("{}/{} demonstrations", i, num_all));
    Recording recording = params_.demonstrations[i].load();
    truths_.push_back(std::exchange(recording.truth, {}));
    return std::make_unique<RecordedTracks>(std::move(recording),
                                            task_.scene_objects, task_.layout,
                                            tracker::IdealTracker::Params{});
  }

  /// In the time of the stream.
  std::vector<ShownStream::Done> Done(
      const std::vector<int64_t>& offsets) const {
    std::vector<ShownStream::Done> done;
    for (size_t i = 0; i < truths_.size(); ++i) {
      for (Recording::TrueAction action : truths_[i]) {
        action.utime += offsets[i];
        done.push_back(
            {params_.demonstrations[i].name, offsets[i], std::move(action)});
      }
    }
    return done;
  }

 private:
  const ShownStreamParams& params_;
  const Task& task_;
  const std::function<void(const std::string&)>& show_;
  std::vector<std::vector<Recording::TrueAction>> truths_;
};

}  // namespace

ShownStream ShowStream(const ShownStreamParams& params,
                       const Deployment& deployment, const Task& task,
                       const std::function<void(const std::string&)>& show,
                       recognizer::Recognition::Observer observe) {
  Demonstrations demonstrations(params, task, show);
  auto joined = std::make_unique<JoinedTracks>(
      [&] { return demonstrations.Next(); }, JoinedTracks::Params{});
  const JoinedTracks& stream = *joined;
  const NoisyTracks::Params noise = PoseNoise(params.noise_mm, params.seed);
  NoisyTracks tracks(std::move(joined), noise);
  auto builder = sec_builder::KeyFrameBuilder::Params::Load(deployment, task);
  builder.smoother.position_sd = noise.position_sd;
  builder.layers.has_places = builder.layers.has_motions = params.has_layers;
  sec_builder::KeyFrameBuilder key_frames(builder);
  recognizer::Recognition recognition(
      task.scene_objects, task.parts, params.library,
      task.MakeSensor(
          PoseUncertainty::OfKeyFrames(noise.position_sd, noise.rotation_sd)),
      recognizer::Recognition::Params::Load(
          deployment.ForService("recognizer")));
  recognition.SetObserver(std::move(observe));
  ShownStream shown;
  while (const auto now = tracks.Next()) {
    const std::vector<KeyFrame> frames = key_frames.Update(*now);
    shown.layers.insert(shown.layers.end(), key_frames.layers().begin(),
                        key_frames.layers().end());
    for (const KeyFrame& frame : frames) {
      for (auto& action : recognition.Update(frame)) {
        shown.recognised.push_back(std::move(action));
      }
    }
  }
  shown.done = demonstrations.Done(stream.offsets());
  return shown;
}

}  // namespace cell::cli
