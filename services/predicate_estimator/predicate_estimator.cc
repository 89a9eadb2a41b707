#include "services/predicate_estimator/predicate_estimator.h"

#include <utility>

#include "cell/predicates_t.hpp"
#include "common/predicates/pose_noise_config.h"
#include "common/scene/scene.h"
#include "common/task/task.h"

namespace cell::predicate_estimator {
namespace {

predicates_t ToMessage(const State& state, const Vocabulary& vocabulary,
                       const KeyFrame& frame) {
  predicates_t message{};
  message.header.utime = frame.utime;
  message.key_frame = frame.index;
  for (int index = 0; index < state.num_atoms(); ++index) {
    const GroundAtom atom = vocabulary.Atom(index);
    const Predicate& predicate =
        vocabulary.predicates()[static_cast<size_t>(atom.predicate)];
    if (predicate.report) continue;
    literal_t& literal = message.literals.emplace_back();
    literal.predicate = predicate.name;
    for (const int object : atom.objects) {
      literal.arguments.push_back(
          vocabulary.objects()[static_cast<size_t>(object)].name);
    }
    literal.num_arguments = static_cast<int32_t>(literal.arguments.size());
    literal.value = static_cast<int8_t>(state.Get(index));
  }
  message.num_literals = static_cast<int32_t>(message.literals.size());
  return message;
}

}  // namespace

PredicateEstimator::PredicateEstimator(Bus& bus, const Params& params)
    : bus_(bus), params_(params) {
  bus.Subscribe<episode_t>("EPISODE",
                           [this](const episode_t& m) { return OnEpisode(m); });
  bus.Subscribe<key_frame_t>(
      "KEY_FRAME", [this](const key_frame_t& m) { return OnKeyFrame(m); });
  bus.Subscribe<tracks_t>("TRACKS",
                          [this](const tracks_t& m) { return OnTracks(m); });
  bus.Subscribe<sense_request_t>("SENSE_REQUEST",
                                 [this](const auto&) { return OnRequest(); });
}

bool PredicateEstimator::OnEpisode(const episode_t& message) {
  const auto event = episode_.Update(message);
  if (event == EpisodeEvent::kBegins) {
    tracks_.reset();
    frame_.reset();
  }
  return event.has_value();
}

bool PredicateEstimator::OnTracks(const tracks_t& message) {
  auto tracks = TracksFromMessage(message, params_.scene_objects);
  if (!tracks) return false;
  tracks_ = *std::move(tracks);
  return true;
}

bool PredicateEstimator::OnKeyFrame(const key_frame_t& message) {
  auto frame = KeyFrameFromMessage(message, params_.scene_objects);
  if (!frame) return false;
  if (episode_.IsBefore(frame->utime)) return true;
  Sense(*frame);
  frame_ = *std::move(frame);
  return true;
}

/// Before the first key frame and tracks there is nothing to say: the planner
/// asks again.
bool PredicateEstimator::OnRequest() {
  if (!frame_ || !tracks_) return true;
  KeyFrame now = *frame_;
  now.utime = tracks_->utime;
  now.poses.clear();
  for (const Track& track : tracks_->tracks) {
    if (params_.scene_objects.IsPart(track.name))
      now.poses[track.name] = track.X_WO;
  }
  Sense(now);
  return true;
}

void PredicateEstimator::Sense(const KeyFrame& frame) {
  const Scene scene =
      SceneOf(frame, tracks_.value_or(Tracks{}), params_.scene_objects);
  bus_.Publish("PREDICATES", ToMessage(params_.sensor->Sense(scene),
                                       params_.vocabulary, frame));
}

std::unique_ptr<Service> MakePredicateEstimator(Bus& bus,
                                                const Deployment& deployment) {
  const Task task = LoadTask(deployment);
  const Config config = deployment.ForService("predicate_estimator");
  const PredicateEstimator::Params params{
      task.scene_objects, task.domain.vocabulary(),
      task.MakeSensor(ReadPoseNoise(config))};
  config.Finish();
  return std::make_unique<PredicateEstimator>(bus, params);
}

}  // namespace cell::predicate_estimator
