#include "common/scene/scene.h"

#include <string>

namespace cell {
namespace {

Sight SightOf(const Track* track) {
  if (track == nullptr) return Sight::kMissing;
  switch (track->state) {
    case Track::State::kTracked:
      return Sight::kSeen;
    case Track::State::kFrozen:
      return Sight::kFrozen;
    case Track::State::kLost:
      return Sight::kMissing;
  }
  return Sight::kMissing;
}

}  // namespace

Scene SceneOf(const KeyFrame& frame, const Cast& cast) {
  Scene scene;
  for (const std::string& part : cast.parts()) {
    Scene::Item& item = scene.items.emplace_back();
    const auto pose = frame.poses.find(part);
    if (pose != frame.poses.end()) {
      item.sight = Sight::kSeen;
      item.X_WO = pose->second;
    }
    for (const std::string& hand : cast.hands()) {
      item.is_held = item.is_held || Touch(frame.relations, part, hand);
    }
    for (const std::string& other : cast.parts()) {
      item.touches.push_back(other != part &&
                             Touch(frame.relations, part, other));
    }
  }
  return scene;
}

Scene SceneOf(const KeyFrame& frame, const Tracks& tracks, const Cast& cast) {
  Scene scene = SceneOf(frame, cast);
  for (size_t i = 0; i < scene.items.size(); ++i) {
    Scene::Item& item = scene.items[i];
    if (item.sight == Sight::kMissing) continue;
    item.sight = SightOf(tracks.Find(cast.parts()[i]));
  }
  return scene;
}

}  // namespace cell
