#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "cell/relation_layers_t.hpp"
#include "common/scene/relation.h"
#include "common/scene/scene_objects.h"

namespace cell {

/// Where the first object of a pair is to the second: the static relations by
/// which the paper enriches event chains (section II-C).
enum class Place : int8_t {
  kNone = 0,
  kInside = 1,   ///< within its outline, and down to its middle
  kHolds = 2,    ///< the second is inside the first
  kOn = 3,       ///< above, and they touch
  kCarries = 4,  ///< below, and they touch
  kAbove = 5,    ///< within reach of its outline, and higher than its middle
  kBelow = 6     ///< the second is above the first
};
/// The relation of the second to the first.
Place Mirrored(Place place);

/// How two objects have moved since the key frame before: the dynamic ones.
enum class Motion : int8_t {
  kNone = 0,
  kGettingCloser = 1,
  kMovingApart = 2,
  kMovingTogether = 3  ///< both, by the same
};

/// The layers of a key frame, beside the relations of touching. Pairs that are
/// not listed have no such relation. A value.
struct RelationLayers {
  int64_t key_frame = 0;  ///< its index
  std::map<ObjectPair, Place> places;
  std::map<ObjectPair, Motion> motions;

  /// Of `a` to `b`.
  Place PlaceOf(const std::string& a, const std::string& b) const;
  Motion MotionOf(const std::string& a, const std::string& b) const;

  bool operator==(const RelationLayers&) const = default;
};

/// Nothing unless its pairs are of the scene's objects, in order, each with a
/// known relation that is not none in both layers.
std::optional<RelationLayers> LayersFromMessage(
    const relation_layers_t& message, const SceneObjects& scene_objects);
/// @param utime  [us] of the key frame
relation_layers_t LayersToMessage(const RelationLayers& layers, int64_t utime);

}  // namespace cell
