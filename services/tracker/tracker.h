#pragma once

#include <memory>
#include <optional>

#include "cell/truth_poses_t.hpp"
#include "common/bus/bus.h"
#include "common/bus/episode_gate.h"
#include "common/config/deployment.h"
#include "common/layout/cell_layout.h"
#include "common/scene/scene_objects.h"
#include "services/tracker/ideal_tracker.h"

namespace cell::tracker {

/// TRUTH_POSES -> TRACKS at camera rate: `sensing: ideal`.
class Tracker final : public Service {
 public:
  struct Params {
    SceneObjects scene_objects;
    CellLayout layout;
    int32_t period_ticks = 12;  ///< of the cameras, 96 ms
    IdealTracker::Params ideal;
  };

  /// `bus` must outlive this object.
  Tracker(Bus& bus, const Params& params);

 private:
  bool OnEpisode(const episode_t& message);
  bool OnTruth(const truth_poses_t& message);
  void PublishTracks();

  Bus& bus_;
  EpisodeGate episode_;
  SceneObjects scene_objects_;
  IdealTracker tracker_;
  std::optional<TruthPoses> truth_;  // not yet published
};

std::unique_ptr<Service> MakeTracker(Bus& bus, const Deployment& deployment);

}  // namespace cell::tracker
