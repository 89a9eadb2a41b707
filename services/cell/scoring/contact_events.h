#pragma once

#include <cstdint>
#include <vector>

#include "common/parts/part_table.h"
#include "common/recordings/track_stream.h"
#include "common/scene/key_frame.h"
#include "common/scene/scene_objects.h"

namespace cell::cli {

/// Two objects begin or cease to touch.
struct ContactEvent {
  int64_t utime = 0;  ///< [us] first frame after the change
  ObjectPair pair;
  bool is_touch = false;  ///< they begin to
};

/// Contact truth: what touches at the true poses, where the distance of convex
/// pieces, or of a hand's points from them, is less than `touch` [m]. Changes
/// that last a single frame are left out, and hands that touch each other.
/// Nothing of the estimator's decisions enters it. By utime.
std::vector<ContactEvent> TrueContactEvents(TrackStream& true_tracks,
                                            const SceneObjects& scene_objects,
                                            const PartTable& parts,
                                            double touch);

/// The changes between consecutive key frames of an episode. By utime.
std::vector<ContactEvent> ContactEventsOf(const std::vector<KeyFrame>& frames,
                                          const SceneObjects& scene_objects);

}  // namespace cell::cli
