#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cell/tracks_t.hpp"
#include "common/scene/scene_objects.h"

namespace cell {

/// What the tracker believes of one part or hand.
struct Track {
  enum class State : int8_t { kTracked = 0, kFrozen = 1, kLost = 2 };
  std::string name;
  State state = State::kTracked;
  double confidence = 1;  ///< 0..1
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector3d> points;  ///< [m] in W; of hands only
};

/// All tracks at one instant, by name.
struct Tracks {
  int64_t utime = 0;  ///< [us since the start of the run]
  std::vector<Track> tracks;

  /// Nothing if there is none of that name.
  const Track* Find(const std::string& name) const;
};

/// Nothing unless every track is of an object of the scene, of the right
/// kind, in the order of names, with a known state and finite numbers.
std::optional<Tracks> TracksFromMessage(const tracks_t& message,
                                        const SceneObjects& scene_objects);
tracks_t TracksToMessage(const Tracks& tracks,
                         const SceneObjects& scene_objects);

}  // namespace cell
