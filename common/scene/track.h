#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cell/tracks_t.hpp"
#include "common/scene/scene_objects.h"

namespace cell {

/// What the tracker believes of one part, hand or unmodelled segment.
struct Track {
  enum class State : int8_t { kTracked = 0, kFrozen = 1, kLost = 2 };
  std::string name;
  State state = State::kTracked;
  double confidence = 1;  ///< 0..1
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  std::vector<Eigen::Vector3d> points;  ///< [m] in W; none of a part
};

/// All tracks at one instant, by name.
struct Tracks {
  int64_t utime = 0;  ///< [us since the start of the run]
  std::vector<Track> tracks;
  /// Of what the task has no model of, with points, by SegmentName().
  std::vector<Track> segments = {};
  /// Names of the message that are no object of the scene and have no points:
  /// nothing is known of where these are.
  std::vector<std::string> left_out = {};

  /// A track or segment; nothing if there is none of that name.
  const Track* Find(const std::string& name) const;
};

/// Nothing unless tracks are in the order of names, with known states and
/// finite numbers, and those of the scene's objects of the right kind. What has
/// another name is a segment, whatever its kind, or left out.
std::optional<Tracks> TracksFromMessage(const tracks_t& message,
                                        const SceneObjects& scene_objects);
tracks_t TracksToMessage(const Tracks& tracks,
                         const SceneObjects& scene_objects);

}  // namespace cell
