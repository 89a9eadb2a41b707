#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "cell/key_frame_t.hpp"
#include "common/scene/relation.h"
#include "common/scene/scene_objects.h"

namespace cell {

/// A column of a semantic event chain, enriched with poses (section V-B).
struct KeyFrame {
  int64_t utime = 0;     ///< [us] when its topology was first seen
  int64_t index = 0;     ///< from 0 in each episode
  TouchGraph relations;  ///< all pairs of the scene's objects
  /// X_WO of the parts that had a track when it was confirmed.
  std::map<std::string, Eigen::Isometry3d> poses;
};

/// Nothing unless the message has all pairs of the scene's objects, each with a
/// known relation, and poses of parts, both in order.
std::optional<KeyFrame> KeyFrameFromMessage(const key_frame_t& message,
                                            const SceneObjects& scene_objects);
key_frame_t KeyFrameToMessage(const KeyFrame& frame);

}  // namespace cell
