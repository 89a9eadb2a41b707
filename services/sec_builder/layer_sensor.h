#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <deque>
#include <map>
#include <string>

#include "common/config/config.h"
#include "common/parts/part_table.h"
#include "common/scene/key_frame.h"
#include "common/scene/relation_layers.h"
#include "common/scene/scene_objects.h"
#include "common/scene/track.h"

namespace cell::sec_builder {

/// Senses the relations that enrich key frames (section II-C), from the extents
/// of objects along the axes of W: of a part its bounding box's, of a hand its
/// points'. Everything is above the table.
///
///   x is above y:  their outlines on the table overlap, and the lowest of x is
///                  higher than the middle of y
///   x is inside y: the outline of x lies within that of y, and the middle of y
///                  is between the lowest of x and the highest
///
/// With the vectors u, v by which the middles of x and y have moved since the
/// key frame before, their distances d before and d' now (from the table: the
/// height of the lowest point), and the least motion m,
///
///   moving together: |u| > m, |v| > m and |u - v| < m, or else
///   getting closer:  d' < d - m,     moving apart: d' > d + m.
class LayerSensor {
 public:
  struct Params {
    bool has_places = false;   ///< senses static relations
    bool has_motions = false;  ///< senses dynamic relations
    double motion = 0.020;     ///< [m] m: less is no motion
    double outline = 0.005;    ///< [m] by which what is inside may stick out

    bool is_on() const { return has_places || has_motions; }
    /// Reads static_relations, dynamic_relations. @throws ConfigError.
    static Params FromConfig(const Config& config);
  };

  LayerSensor(const SceneObjects& scene_objects, const PartTable& parts,
              const Params& params);

  /// Takes the next tracks.
  void Update(const Tracks& tracks);
  /// The layers of a key frame of these tracks, which is not older than
  /// kMemoryUs. The frames come in their order.
  RelationLayers Sense(const KeyFrame& frame);

  static constexpr int64_t kMemoryUs = 10'000'000;

 private:
  using Extents = std::map<std::string, Eigen::AlignedBox3d>;  // in W
  struct Moment {
    int64_t utime = 0;  // [us]
    Extents extents;    // of what was tracked
  };

  const Extents& ExtentsAt(int64_t utime) const;
  Place PlaceOf(const std::string& a, const std::string& b,
                const Extents& now) const;
  Motion MotionOf(const std::string& a, const std::string& b,
                  const Extents& now) const;
  bool IsInside(const Eigen::AlignedBox3d& a,
                const Eigen::AlignedBox3d& b) const;

  SceneObjects scene_objects_;
  Params params_;
  std::map<std::string, Eigen::AlignedBox3d> boxes_;  // of parts, in O
  std::deque<Moment> moments_;
  Extents before_;  // at the last key frame
};

}  // namespace cell::sec_builder
