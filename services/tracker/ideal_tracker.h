#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "common/geometry/truth_poses.h"
#include "common/layout/cell_layout.h"
#include "common/scene/scene_objects.h"
#include "common/scene/track.h"

namespace cell::tracker {

/// Stands in for perfect sensing: tracks made of ground truth, so that the
/// levels above can be built and judged by themselves (section IV). Parts are
/// tracked with confidence 1; hands are points on their surface, grippers
/// points on their fingers.
class IdealTracker {
 public:
  struct Params {
    double hand_spacing = 0.008;  ///< [m] of surface points: finer than contact
  };

  /// A hand is the boxes of `layout`, its bodies' frames at their centres.
  IdealTracker(const SceneObjects& scene_objects, const CellLayout& layout,
               const Params& params);

  /// A track of every part in `truth`, and of every hand with all its bodies
  /// there.
  Tracks Update(const TruthPoses& truth) const;

 private:
  /// Adds the hand's track if it can be made.
  void TrackHand(const std::string& hand, const TruthPoses& truth,
                 Tracks& tracks) const;

  SceneObjects scene_objects_;
  /// Surface points of the bodies of each hand.
  using Surfaces = std::map<std::string, std::vector<Eigen::Vector3d>>;
  std::map<std::string, Surfaces> surfaces_;
};

}  // namespace cell::tracker
