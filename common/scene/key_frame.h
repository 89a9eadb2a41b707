#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cell/key_frame_t.hpp"
#include "common/scene/relation.h"
#include "common/scene/scene_objects.h"

namespace cell {

/// Where in the log the trajectory that led to a key frame is, and the forces
/// if a robot acted.
struct LogSegment {
  int64_t begin_utime = 0;            ///< [us] of the previous key frame
  std::vector<std::string> channels;  ///< sorted
};

/// A column of a semantic event chain, enriched with poses (section V-B).
struct KeyFrame {
  int64_t utime = 0;     ///< [us] when its topology was first seen
  int64_t index = 0;     ///< from 0 in each episode
  TouchGraph relations;  ///< all pairs of the scene's objects
  /// X_WO of the parts that had a track when it was confirmed.
  std::map<std::string, Eigen::Isometry3d> poses;
  /// X_AB of the pairs (A, B) that touch or overlap and had tracks (section
  /// II-C). The table's frame is W; a hand's is at its centroid, with W's axes.
  std::map<ObjectPair, Eigen::Isometry3d> relative_poses = {};
  LogSegment segment = {};  ///< ends with this key frame
  /// Of the unmodelled segments that are there (SegmentName()), with all
  /// objects and each other.
  TouchGraph segment_relations = {};
};

/// The relations of the frame among which those of such a pair are.
TouchGraph& RelationsWith(const ObjectPair& pair, KeyFrame* frame);

/// Nothing unless the message has all pairs of the scene's objects and of any
/// segments, each with a known relation, poses of parts, and relative poses of
/// pairs that touch, all in order, and a segment that ends with it.
std::optional<KeyFrame> KeyFrameFromMessage(const key_frame_t& message,
                                            const SceneObjects& scene_objects);
key_frame_t KeyFrameToMessage(const KeyFrame& frame);

}  // namespace cell
