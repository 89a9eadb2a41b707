#pragma once

#include <memory>
#include <optional>

#include "cell/episode_t.hpp"
#include "cell/key_frame_t.hpp"
#include "cell/tracks_t.hpp"
#include "common/bus/bus.h"
#include "common/config/deployment.h"
#include "common/relational/vocabulary.h"
#include "common/sec/cast.h"
#include "common/sec/predicate_sensor.h"
#include "common/sec/track.h"

namespace cell {

/// KEY_FRAME, TRACKS -> PREDICATES: all ground predicates, sensed afresh at
/// each key frame (section VII-B). Relations and poses are the key frame's;
/// the latest tracks say whose pose is seen. Nothing else is kept.
class PredicateEstimator final : public Service {
 public:
  struct Params {
    Cast cast;
    Vocabulary vocabulary;
    std::shared_ptr<const PredicateSensor> sensor;
  };

  /// `bus` must outlive this object.
  PredicateEstimator(Bus& bus, const Params& params);

 private:
  bool OnEpisode(const episode_t& message);
  bool OnTracks(const tracks_t& message);
  bool OnKeyFrame(const key_frame_t& message);

  Bus& bus_;
  Params params_;
  std::optional<Tracks> tracks_;  // the latest
  int64_t start_utime_ = 0;       // of the episode
};

std::unique_ptr<Service> MakePredicateEstimator(Bus& bus,
                                                const Deployment& deployment);

}  // namespace cell
