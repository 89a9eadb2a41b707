#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "common/parts/part_table.h"
#include "common/scene/key_frame.h"
#include "common/scene/scene_objects.h"
#include "common/scene/track.h"

namespace cell {

/// What is known of a part at an instant.
enum class Visibility {
  kSeen,    ///< tracked
  kFrozen,  ///< hidden; its pose is the last one seen
  kMissing  ///< its pose is not known
};

/// What is known of the parts at an instant, by index in the part table.
struct Scene {
  struct Item {
    Visibility visibility = Visibility::kMissing;
    Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
    bool is_held = false;       ///< a hand touches it
    std::vector<bool> touches;  ///< each part
  };
  std::vector<Item> items;
};

/// The scene at a key frame.
/// Each part that has a pose counts as seen.
Scene SceneOf(const KeyFrame& frame, const SceneObjects& scene_objects);

/// The same, but a part counts as seen if its track does; without a track it is
/// missing.
Scene SceneOf(const KeyFrame& frame, const Tracks& tracks,
              const SceneObjects& scene_objects);

}  // namespace cell
