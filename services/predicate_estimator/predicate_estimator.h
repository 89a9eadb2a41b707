#pragma once

#include <memory>
#include <optional>

#include "cell/key_frame_t.hpp"
#include "cell/sense_request_t.hpp"
#include "cell/tracks_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/episode_gate.h"
#include "common/config/deployment.h"
#include "common/predicates/predicate_sensor.h"
#include "common/relational/vocabulary.h"
#include "common/scene/key_frame.h"
#include "common/scene/scene_objects.h"
#include "common/scene/track.h"

namespace cell::predicate_estimator {

/// KEY_FRAME, TRACKS, SENSE_REQUEST -> PREDICATES: all ground predicates that
/// geometry can decide, sensed at each key frame (section VII-B) and on
/// request. Relations and poses are the key frame's; which poses are seen is
/// taken from the latest tracks. What poses of the noise that it is told of
/// cannot decide is unknown. On request relations are the latest key frame's,
/// poses and time the latest tracks'. Keeps nothing else.
class PredicateEstimator final : public Service {
 public:
  struct Params {
    SceneObjects scene_objects;
    Vocabulary vocabulary;
    std::shared_ptr<const PredicateSensor> sensor;
  };

  /// `bus` must outlive this object.
  PredicateEstimator(Bus& bus, const Params& params);

 private:
  bool OnEpisode(const episode_t& message);
  bool OnTracks(const tracks_t& message);
  bool OnKeyFrame(const key_frame_t& message);
  bool OnRequest();
  void Sense(const KeyFrame& frame);

  Bus& bus_;
  EpisodeGate episode_;
  Params params_;
  std::optional<Tracks> tracks_;   // the latest
  std::optional<KeyFrame> frame_;  // the latest
};

std::unique_ptr<Service> MakePredicateEstimator(Bus& bus,
                                                const Deployment& deployment);

}  // namespace cell::predicate_estimator
