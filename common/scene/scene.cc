#include "common/scene/scene.h"

#include <string>

namespace cell {
namespace {

Visibility VisibilityOf(const Track* track) {
  if (track == nullptr) return Visibility::kMissing;
  switch (track->state) {
    case Track::State::kTracked:
      return Visibility::kSeen;
    case Track::State::kFrozen:
      return Visibility::kFrozen;
    case Track::State::kLost:
      return Visibility::kMissing;
  }
  return Visibility::kMissing;
}

}  // namespace

Scene SceneOf(const KeyFrame& frame, const SceneObjects& scene_objects) {
  Scene scene;
  for (const std::string& part : scene_objects.parts()) {
    Scene::Item& item = scene.items.emplace_back();
    const auto pose = frame.poses.find(part);
    if (pose != frame.poses.end()) {
      item.visibility = Visibility::kSeen;
      item.X_WO = pose->second;
    }
    for (const std::string& hand : scene_objects.hands()) {
      item.is_held = item.is_held || Touch(frame.relations, part, hand);
    }
    for (const std::string& other : scene_objects.parts()) {
      item.touches.push_back(other != part &&
                             Touch(frame.relations, part, other));
    }
  }
  return scene;
}

Scene SceneOf(const KeyFrame& frame, const Tracks& tracks,
              const SceneObjects& scene_objects) {
  Scene scene = SceneOf(frame, scene_objects);
  for (size_t i = 0; i < scene.items.size(); ++i) {
    Scene::Item& item = scene.items[i];
    if (item.visibility == Visibility::kMissing) continue;
    item.visibility = VisibilityOf(tracks.Find(scene_objects.parts()[i]));
  }
  return scene;
}

}  // namespace cell
