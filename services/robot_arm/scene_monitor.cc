#include "services/robot_arm/scene_monitor.h"

#include <algorithm>
#include <utility>

namespace cell::robot_arm {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kHandMoving = 1e-4;  // [m] of a point between two looks
constexpr double kMoving = 1e-4;      // [rad] of a joint in a tick

// With a grip that the hand has: its first if it has not this one.
ArmPosture Posture(const ArmLayout& arm, const ArmPosture& posture) {
  ArmPosture known = posture;
  if (arm.hand.FindGrip(posture.grip) == nullptr) {
    known.grip = arm.hand.grips.front().name;
  }
  return known;
}

// Somewhere on the way it is nearer than `before`, so that it may leave what it
// is too near to. distance(posture) [m] is cut off at what is wanted.
template <class Distance>
bool ComesNearer(ArmPosture posture, const SceneMonitor::WayAhead& way,
                 double before, const Distance& distance) {
  return std::ranges::any_of(way, [&](const std::optional<Joints>& ahead) {
    if (!ahead) return false;
    posture.q = *ahead;
    return distance(posture) < before;
  });
}

}  // namespace

SceneMonitor::SceneMonitor(Params params)
    : params_(std::move(params)),
      arm_(*params_.layout.FindArm(params_.arm)),
      scene_(params_.parts, params_.layout) {
  for (const Part& part : params_.parts.parts()) {
    shapes_.emplace(part.name, PartShape(part));
  }
}

void SceneMonitor::Arrange() {
  scene_.LetGo(arm_.name);
  for (const auto& [arm, other] : others_) scene_.LetGo(arm);
  scene_.PutParts(poses_);
  for (const auto& [arm, other] : others_) {
    if (other.held) scene_.Hold(arm, other.held->part, other.held->X_GO);
  }
  if (held_) scene_.Hold(arm_.name, held_->part, held_->X_GO);
}

void SceneMonitor::SetParts(const std::map<std::string, Isometry3d>& poses) {
  poses_ = poses;
  Arrange();
}

void SceneMonitor::SetHeld(const std::optional<HeldPart>& held) {
  held_ = held;
  Arrange();
}

std::optional<std::string> SceneMonitor::FindGrasped(
    const ArmPosture& posture) const {
  return scene_.FindGrasped(arm_.name, Posture(arm_, posture));
}

MotionRequest SceneMonitor::MakeRequest(MotionRequest::Kind kind,
                                        const ArmPosture& posture) const {
  MotionRequest request;
  request.arm = arm_.name;
  request.kind = kind;
  for (const ArmLayout& arm : params_.layout.arms) {
    const bool is_own = arm.name == arm_.name;
    request.arms[arm.name] = {
        is_own ? Posture(arm_, posture) : scene_.PostureOf(arm.name),
        scene_.HeldBy(arm.name)};
  }
  request.parts = poses_;
  return request;
}

// ---- other arms

void SceneMonitor::SetOther(const std::string& arm, const ArmPosture& posture,
                            bool is_gripping) {
  const ArmLayout* layout = params_.layout.FindArm(arm);
  if (layout == nullptr) return;
  const ArmPosture known = Posture(*layout, posture);
  scene_.SetPosture(arm, known);
  Other& other = others_[arm];
  other.is_moving =
      other.q && (*other.q - posture.q).cwiseAbs().maxCoeff() > kMoving;
  other.q = posture.q;
  if (is_gripping == other.held.has_value()) return;
  // It goes with the hand from here on: tracks come later than the hand.
  other.held.reset();
  if (is_gripping) {
    const auto part = scene_.FindGrasped(arm, known);
    if (!part) return;
    other.held = {*part,
                  GripperPose(*layout, posture.q).inverse() * poses_.at(*part)};
  }
  Arrange();
}

bool SceneMonitor::WouldCollideWithArm(const ArmPosture& now,
                                       const WayAhead& way) const {
  const bool is_moving = std::ranges::any_of(
      others_, [](const auto& other) { return other.second.is_moving; });
  const double wanted =
      is_moving ? params_.distances.moving_arm : params_.distances.standing_arm;
  const auto distance = [&](const ArmPosture& posture) {
    return scene_.DistanceToOthers(arm_.name, posture, wanted);
  };
  const ArmPosture here = Posture(arm_, now);
  return ComesNearer(here, way, distance(here), distance);
}

bool SceneMonitor::IsNearSomething(const Joints& q) const {
  return scene_
      .WhyBlocked(arm_.name, Posture(arm_, {q, "", 0}), {params_.clearance, {}})
      .has_value();
}

// ---- people's hands

void SceneMonitor::SetHands(std::vector<Vector3d> points) {
  const auto& last = hands_.points();
  is_hand_moving_ = !std::ranges::equal(
      points, last, [](const Vector3d& a, const Vector3d& b) {
        return (a - b).norm() < kHandMoving;
      });
  hands_ = PointCloud(std::move(points));
  in_hands_.clear();
  for (const auto& [part, X_WO] : poses_) {
    const bool is_mine = held_ && held_->part == part;
    if (!is_mine && IsInHand(part)) in_hands_.push_back(part);
  }
}

bool SceneMonitor::IsInHand(const std::string& part) const {
  return shapes_.at(part).DistanceTo(hands_, poses_.at(part),
                                     params_.distances.in_hand) <
         params_.distances.in_hand;
}

bool SceneMonitor::WouldCollideWithPerson(const ArmPosture& now,
                                          const WayAhead& way) const {
  if (!is_hand_moving_ && in_hands_.empty()) return false;
  const auto distance = [&](const ArmPosture& posture) {
    return scene_.DistanceTo(hands_, in_hands_, arm_.name, posture,
                             params_.distances.hands_at_work);
  };
  const ArmPosture here = Posture(arm_, now);
  const double before = distance(here);
  const bool stays = std::ranges::any_of(
      way, [](const auto& ahead) { return !ahead.has_value(); });
  // So near it does not even draw back: the hand's motion is not known.
  if (before < (stays ? params_.distances.hands_at_work
                      : params_.distances.hands_too_near))
    return true;
  return ComesNearer(here, way, before, distance);
}

bool SceneMonitor::IsHandNear(const Vector3d& p_W) const {
  return std::ranges::any_of(hands_.points(), [&](const Vector3d& p) {
    return (p - p_W).norm() < params_.distances.hands;
  });
}

}  // namespace cell::robot_arm
