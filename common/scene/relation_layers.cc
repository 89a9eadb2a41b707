#include "common/scene/relation_layers.h"

#include <set>

namespace cell {
namespace {

template <class Layer>
typename Layer::mapped_type Find(const Layer& layer, const ObjectPair& pair) {
  const auto it = layer.find(pair);
  return it == layer.end() ? typename Layer::mapped_type{} : it->second;
}

}  // namespace

Place Mirrored(Place place) {
  switch (place) {
    case Place::kInside:
      return Place::kHolds;
    case Place::kHolds:
      return Place::kInside;
    case Place::kOn:
      return Place::kCarries;
    case Place::kCarries:
      return Place::kOn;
    case Place::kAbove:
      return Place::kBelow;
    case Place::kBelow:
      return Place::kAbove;
    case Place::kNone:
      break;
  }
  return Place::kNone;
}

Place RelationLayers::PlaceOf(const std::string& a,
                              const std::string& b) const {
  const Place place = Find(places, MakePair(a, b));
  return a < b ? place : Mirrored(place);
}

Motion RelationLayers::MotionOf(const std::string& a,
                                const std::string& b) const {
  return Find(motions, MakePair(a, b));
}

std::optional<RelationLayers> LayersFromMessage(
    const relation_layers_t& message, const SceneObjects& scene_objects) {
  if (message.key_frame < 0) return std::nullopt;
  RelationLayers layers{message.key_frame, {}, {}};
  std::optional<ObjectPair> last;
  for (const spatial_relation_t& r : message.relations) {
    const ObjectPair pair(r.first, r.second);
    if (!scene_objects.Has(r.first) || !scene_objects.Has(r.second) ||
        pair.first >= pair.second || (last && pair <= *last)) {
      return std::nullopt;
    }
    last = pair;
    const bool is_known = r.place >= spatial_relation_t::NONE &&
                          r.place <= spatial_relation_t::BELOW &&
                          r.motion >= spatial_relation_t::NONE &&
                          r.motion <= spatial_relation_t::MOVING_TOGETHER;
    if (!is_known || (r.place == 0 && r.motion == 0)) return std::nullopt;
    if (r.place != 0) layers.places.emplace(pair, Place{r.place});
    if (r.motion != 0) layers.motions.emplace(pair, Motion{r.motion});
  }
  return layers;
}

relation_layers_t LayersToMessage(const RelationLayers& layers, int64_t utime) {
  relation_layers_t message{};
  message.header.utime = utime;
  message.key_frame = layers.key_frame;
  std::set<ObjectPair> pairs;
  for (const auto& [pair, place] : layers.places) pairs.insert(pair);
  for (const auto& [pair, motion] : layers.motions) pairs.insert(pair);
  for (const ObjectPair& pair : pairs) {
    spatial_relation_t& r = message.relations.emplace_back();
    r.first = pair.first;
    r.second = pair.second;
    r.place = static_cast<int8_t>(Find(layers.places, pair));
    r.motion = static_cast<int8_t>(Find(layers.motions, pair));
  }
  message.num_relations = static_cast<int32_t>(message.relations.size());
  return message;
}

}  // namespace cell
