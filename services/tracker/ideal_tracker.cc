#include "services/tracker/ideal_tracker.h"

#include <utility>

#include "common/geometry/box_surface.h"

namespace cell::tracker {

IdealTracker::IdealTracker(const SceneObjects& scene_objects,
                           const CellLayout& layout, const Params& params)
    : scene_objects_(scene_objects) {
  const auto add = [&](const std::string& hand, const HandType::Box& box) {
    surfaces_[hand][hand + "." + box.name] =
        SampleBoxSurface(box.half_extents, params.hand_spacing);
  };
  for (const CellLayout::Hand& hand : layout.hands) {
    for (const HandType::Box& box : hand.type.boxes) add(hand.name, box);
  }
  for (const ArmLayout& arm : layout.arms) {
    for (const HandType::Box& box : arm.hand.Fingers()) add(arm.gripper, box);
  }
}

Tracks IdealTracker::Update(const TruthPoses& truth) const {
  Tracks tracks{truth.utime, {}};
  for (const std::string& name : scene_objects_.names()) {
    if (scene_objects_.IsHand(name)) {
      TrackHand(name, truth, tracks);
      continue;
    }
    const auto pose = truth.poses.find(name);
    if (!scene_objects_.IsPart(name) || pose == truth.poses.end()) continue;
    tracks.tracks.push_back(
        {name, Track::State::kTracked, 1, pose->second, {}});
  }
  return tracks;
}

void IdealTracker::TrackHand(const std::string& hand, const TruthPoses& truth,
                             Tracks& tracks) const {
  Track track;
  track.name = hand;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& [body, surface] : surfaces_.at(hand)) {
    const auto pose = truth.poses.find(body);
    if (pose == truth.poses.end()) return;
    for (const Eigen::Vector3d& p_B : surface) {
      track.points.push_back(pose->second * p_B);
      sum += track.points.back();
    }
  }
  track.X_WO.translation() = sum / static_cast<double>(track.points.size());
  tracks.tracks.push_back(std::move(track));
}

}  // namespace cell::tracker
