#pragma once

#include <map>
#include <string>
#include <vector>

#include "common/geometry/part_shape.h"
#include "common/parts/part_table.h"
#include "common/scene/relation.h"
#include "common/scene/scene_objects.h"
#include "common/scene/track.h"

namespace cell::sec_builder {

/// How near two objects are.
struct Proximity {
  double distance = 0;  ///< [m] 0 if they penetrate
  /// [m] by which the smaller one is inside the bounding box of the other;
  /// negative if it sticks out
  double slack = -1;
};
using Proximities = std::map<ObjectPair, Proximity>;

/// Measures how near the objects of a scene are, from their shapes at the
/// tracked poses; hands and unmodelled segments are their points.
class ProximitySensor {
 public:
  struct Params {
    double enough = 0.002;  ///< [m] nearer than this is not told apart
    double cutoff = 0.015;  ///< [m] nor is what is further
  };

  ProximitySensor(const SceneObjects& scene_objects, const PartTable& parts,
                  const Params& params);

  /// All pairs of objects with a state TRACKED, unmodelled segments and the
  /// table included.
  Proximities Measure(const Tracks& tracks) const;

 private:
  /// An object of the scene as it is now: a part, a hand, a segment or the
  /// table.
  struct Posed {
    const Track* track = nullptr;      // nullptr: the table
    const PartShape* shape = nullptr;  // of a part
    PointCloud cloud{{}};              // of a hand or segment
  };

  Proximity Between(const Posed& a, const Posed& b) const;
  Proximity OfParts(const Posed& a, const Posed& b) const;
  double FromTable(const Posed& object) const;
  double OfClouds(const PointCloud& a, const PointCloud& b) const;

  SceneObjects scene_objects_;
  Params params_;
  std::map<std::string, PartShape> shapes_;
};

}  // namespace cell::sec_builder
