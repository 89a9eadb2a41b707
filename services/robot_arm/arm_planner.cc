#include "services/robot_arm/arm_planner.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "services/robot_arm/transit.h"

namespace cell::robot_arm {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

// Ways to take and to place that are looked at.
constexpr size_t kBestFew = 8, kBestTransfers = 4, kAll = 1000;
constexpr double kMoved = 0.002;       // [m] a part has moved
constexpr double kTurned = 0.01;       // [rad] or turned
constexpr double kFromHands = 0.25;    // [m] that people's hands are given
constexpr double kHandMoving = 1e-4;   // [m] of a point between two looks
constexpr double kAtPeople = 0.05;     // [m] of hands at work
constexpr double kFromPeople = 0.1;    // [m] of hands at work
constexpr double kInHand = 0.015;      // [m] nearer than this a hand holds it
constexpr double kGrid = 0.03;         // [m] of the free places that are tried
constexpr int kYaws = 12;              // turns that are tried there
constexpr double kOverTable = 0.0005;  // [m] a part is set down from
// [m] Around a part that is set down, if there is room: its neighbours want to
// be taken, too.
constexpr double kApart[] = {0.06, 0.03, 0.012};
constexpr double kNear = 0.0015;      // [m] at a grasp or a place
constexpr double kMoving = 1e-4;      // [rad] of a joint in a tick
constexpr double kFromStill = 0.006;  // [m] that an arm that stands is given
constexpr double kFromMoving = 0.06;  // [m] that an arm that moves is given

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
bool ComesNearer(ArmPosture posture, const ArmPlanner::WayAhead& way,
                 double before, const Distance& distance) {
  return std::ranges::any_of(way, [&](const std::optional<Joints>& ahead) {
    if (!ahead) return false;
    posture.q = *ahead;
    return distance(posture) < before;
  });
}

// Of choices that bring the gripper to about the same place in the same
// configuration one is enough: the others have the same way, or none.
class TriedWays {
 public:
  explicit TriedWays(const ArmLayout& arm) : arm_(arm) {}

  // True if nothing like it was tried; it counts as tried from now on.
  bool Add(const Joints& q) {
    const Way way{arm_.model->ConfigurationOf(q),
                  GripperPose(arm_, q).translation()};
    const bool is_known = std::ranges::any_of(ways_, [&](const Way& other) {
      return other.configuration == way.configuration &&
             (other.p_WG - way.p_WG).norm() < kSamePlace;
    });
    if (!is_known) ways_.push_back(way);
    return !is_known;
  }

 private:
  static constexpr double kSamePlace = 0.03;  // [m]
  struct Way {
    IkConfiguration configuration;
    Vector3d p_WG;
  };
  const ArmLayout& arm_;
  std::vector<Way> ways_;
};

// The first choice to which plan(choice) knows a way; else why the first of all
// has none.
template <class Choice, class Plan>
void FindWay(const std::vector<Choice>& choices, TriedWays* tried,
             const Plan& plan, OrReason<Choice>* planned) {
  for (const Choice& choice : choices) {
    if (!tried->Add(choice.q_approach)) continue;
    const OrReason<JointTrajectory> way = plan(choice);
    const auto* reason = std::get_if<std::string>(&way);
    if (reason == nullptr) {
      *planned = choice;
      return;
    }
    if (auto* why = std::get_if<std::string>(planned); why->empty()) {
      *why = *reason;
    }
  }
}

ReachParams ReachParamsOf(const SkillSettings& settings) {
  ReachParams params;
  params.approach = settings.motion.approach;
  params.open_margin = 2 * settings.fingers.open_margin;
  params.clearance = kNear;
  return params;
}

}  // namespace

bool HasMoved(const Isometry3d& X_WO_before, const Isometry3d& X_WO_now) {
  return (X_WO_before.translation() - X_WO_now.translation()).norm() >=
             kMoved ||
         AngleAxisd(X_WO_before.linear().transpose() * X_WO_now.linear())
                 .angle() >= kTurned;
}

ArmPlanner::ArmPlanner(const Params& params)
    : params_(params),
      arm_(*params_.layout.FindArm(params.arm)),
      scene_(params_.parts, params_.layout),
      bare_(params_.parts, params_.layout) {
  for (const Part& part : params_.parts.parts()) {
    shapes_.emplace(part.name, PartShape(part));
  }
}

// ---- the scene

void ArmPlanner::Arrange() {
  scene_.LetGo(arm_.name);
  for (const auto& [arm, other] : others_) scene_.LetGo(arm);
  scene_.PutParts(poses_);
  for (const auto& [arm, other] : others_) {
    if (other.held) scene_.Hold(arm, other.held->part, other.held->X_GO);
  }
  if (held_) scene_.Hold(arm_.name, held_->part, held_->X_GO);
}

void ArmPlanner::SetParts(const std::map<std::string, Isometry3d>& poses) {
  poses_ = poses;
  Arrange();
  for (const auto& [name, X_WO] : poses_) {
    if (params_.parts.Find(name)->is_fixed) bare_.PutPart(name, X_WO);
  }
}

void ArmPlanner::SetOther(const std::string& arm, const ArmPosture& posture,
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

bool ArmPlanner::MeetsOther(const ArmPosture& now, const WayAhead& way) const {
  const bool is_moving = std::ranges::any_of(
      others_, [](const auto& other) { return other.second.is_moving; });
  const double wanted = is_moving ? kFromMoving : kFromStill;
  const auto distance = [&](const ArmPosture& posture) {
    return scene_.DistanceToOthers(arm_.name, posture, wanted);
  };
  const ArmPosture here = Posture(arm_, now);
  return ComesNearer(here, way, distance(here), distance);
}

void ArmPlanner::SetHeld(const std::optional<HeldPart>& held) {
  held_ = held;
  Arrange();
}

std::optional<std::string> ArmPlanner::FindGrasped(
    const ArmPosture& posture) const {
  return scene_.FindGrasped(arm_.name, Posture(arm_, posture));
}

// ---- ways

// What other arms are in the way of now can be done when they have gone home.
template <class Plan>
auto ArmPlanner::NowOrLater(const Plan& plan) const {
  auto planned = plan(scene_);
  if (!std::holds_alternative<std::string>(planned)) return planned;
  ArmScene later = scene_;
  for (const ArmLayout& other : params_.layout.arms) {
    if (other.name != arm_.name) {
      later.SetPosture(other.name, HomePosture(other));
    }
  }
  auto planned_later = plan(later);
  return std::holds_alternative<std::string>(planned_later) ? planned
                                                            : planned_later;
}

// The best few are looked at first, then all.
OrReason<GraspChoice> ArmPlanner::PlanPick(
    const std::string& part, const std::optional<PlaceTarget>& target,
    const Joints& q) const {
  using Grasps = std::vector<GraspChoice>;
  OrReason<GraspChoice> planned = "";
  TriedWays tried(arm_);
  for (const size_t most : {kBestFew, kAll}) {
    const auto grasps =
        NowOrLater([&](const ArmScene& scene) -> OrReason<Grasps> {
          return GraspsIn(scene, part, target, q, most);
        });
    if (auto* reason = std::get_if<std::string>(&grasps)) {
      if (std::get<std::string>(planned).empty()) planned = *reason;
      continue;
    }
    const auto plan = [&](const GraspChoice& grasp) {
      return PlanTransit(q, grasp.q_approach, grasp.opening, grasp.grip);
    };
    FindWay(std::get<Grasps>(grasps), &tried, plan, &planned);
    if (std::holds_alternative<GraspChoice>(planned)) break;
  }
  return planned;
}

OrReason<std::vector<GraspChoice>> ArmPlanner::GraspsIn(
    const ArmScene& scene, const std::string& part,
    const std::optional<PlaceTarget>& target, const Joints& q,
    size_t most) const {
  ReachParams params = ReachParamsOf(params_.settings);
  params.max_choices = most;
  const Reach reach(scene, arm_.name, params);
  if (!target) {
    const auto grasps = reach.Grasps(part, q);
    if (!grasps) return grasps.reason;
    return grasps.list;
  }
  const auto transfers =
      reach.Transfers(part, *target, q, most == kAll ? kAll : kBestTransfers);
  if (!transfers) return transfers.reason;
  std::vector<GraspChoice> grasps;
  for (const auto& transfer : transfers.list) grasps.push_back(transfer.grasp);
  return grasps;
}

OrReason<PlaceChoice> ArmPlanner::PlanPlace(const PlaceTarget& target,
                                            const Joints& q) const {
  using Places = std::vector<PlaceChoice>;
  OrReason<PlaceChoice> planned = "";
  TriedWays tried(arm_);
  for (const size_t most : {kBestFew, kAll}) {
    const auto places = NowOrLater([&](const ArmScene& scene) {
      return PlacesIn(scene, target, q, most);
    });
    if (auto* reason = std::get_if<std::string>(&places)) {
      if (std::get<std::string>(planned).empty()) planned = *reason;
      continue;
    }
    const auto plan = [&](const PlaceChoice& place) {
      return PlanTransit(q, place.q_approach, held_->width, held_->grip);
    };
    FindWay(std::get<Places>(places), &tried, plan, &planned);
    if (std::holds_alternative<PlaceChoice>(planned)) break;
  }
  return planned;
}

OrReason<std::vector<PlaceChoice>> ArmPlanner::PlacesIn(
    const ArmScene& scene, const PlaceTarget& target, const Joints& q,
    size_t most) const {
  ReachParams params = ReachParamsOf(params_.settings);
  params.max_choices = most;
  const Reach reach(scene, arm_.name, params);
  const ArmPosture holding = Posture(arm_, {q, held_->grip, held_->width});
  const auto places = reach.Placements(held_->part, held_->X_GO, holding.grip,
                                       holding.opening, target, q);
  if (!places) return "its place: " + places.reason;
  return places.list;
}

OrReason<JointTrajectory> ArmPlanner::PlanTransit(
    const Joints& from, const Joints& to, double opening,
    const std::string& grip) const {
  const ArmPosture posture = Posture(arm_, {from, grip, opening});
  return NowOrLater([&](const ArmScene& scene) {
    return PlanWay(scene, arm_.name, posture, to, params_.settings.motion);
  });
}

OrReason<PlaceTarget> ArmPlanner::FindFreePlace(const Eigen::AlignedBox2d& area,
                                                Taker taker,
                                                const Joints& q) const {
  return NowOrLater([&](const ArmScene& scene) {
    return FreePlaceIn(scene, area, taker, q);
  });
}

OrReason<PlaceTarget> ArmPlanner::FreePlaceIn(const ArmScene& scene,
                                              const Eigen::AlignedBox2d& area,
                                              Taker taker,
                                              const Joints& q) const {
  std::vector<Eigen::Vector2d> points;
  for (double y = area.min().y(); y <= area.max().y(); y += kGrid) {
    for (double x = area.min().x(); x <= area.max().x(); x += kGrid) {
      points.emplace_back(x, y);
    }
  }
  std::ranges::stable_sort(points, {}, [&](const Eigen::Vector2d& p) {
    return (p - area.center()).norm();
  });
  const double bottom = shapes_.at(held_->part).LowestZ(Isometry3d::Identity());
  // The parts' table turns those by itself that look the same all round.
  const int num_yaws =
      params_.parts.Find(held_->part)->symmetry_order == 0 ? 1 : kYaws;
  PlaceTarget target;
  target.approach = params_.settings.motion.approach;
  for (const double apart : kApart) {
    for (const Eigen::Vector2d& p : points) {
      for (int i = 0; i < num_yaws; ++i) {
        target.X_WO =
            Translation3d(p.x(), p.y(), kOverTable - bottom) *
            AngleAxisd(2 * std::numbers::pi * i / num_yaws, Vector3d::UnitZ());
        const auto near = scene.Neighbours(held_->part, target.X_WO, apart);
        if (near.size() > 1) continue;  // than the table
        const auto places = PlacesIn(scene, target, q, 1);
        if (!std::holds_alternative<std::string>(places) &&
            (taker == Taker::kAnyone || CanOtherTake(scene, target.X_WO))) {
          return target;
        }
      }
    }
  }
  return taker == Taker::kAnyone
             ? "there is no free place on the table"
             : "there is no free place on the table for the other arm to take "
               "it from";
}

/// What it holds, once it stands at X_WO.
bool ArmPlanner::CanOtherTake(const ArmScene& scene,
                              const Isometry3d& X_WO) const {
  ArmScene then = scene;
  then.LetGo(arm_.name);
  then.PutPart(held_->part, X_WO);
  for (const ArmLayout& arm : params_.layout.arms) {
    then.SetPosture(arm.name, HomePosture(arm));
  }
  return std::ranges::any_of(params_.layout.arms, [&](const ArmLayout& other) {
    if (other.name == arm_.name) return false;
    const Reach reach(then, other.name, ReachParamsOf(params_.settings));
    return bool(reach.Grasps(held_->part, other.home));
  });
}

bool ArmPlanner::IsNearSomething(const Joints& q) const {
  return scene_
      .WhyBlocked(arm_.name, Posture(arm_, {q, "", 0}),
                  {params_.settings.motion.clearance, {}})
      .has_value();
}

// ---- people's hands

void ArmPlanner::SetHands(std::vector<Vector3d> points) {
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

bool ArmPlanner::IsInHand(const std::string& part) const {
  return shapes_.at(part).DistanceTo(hands_, poses_.at(part), kInHand) <
         kInHand;
}

bool ArmPlanner::MeetsPerson(const ArmPosture& now, const WayAhead& way) const {
  if (!is_hand_moving_ && in_hands_.empty()) return false;
  const auto distance = [&](const ArmPosture& posture) {
    return scene_.DistanceTo(hands_, in_hands_, arm_.name, posture,
                             kFromPeople);
  };
  const ArmPosture here = Posture(arm_, now);
  const double before = distance(here);
  const bool stays = std::ranges::any_of(
      way, [](const auto& ahead) { return !ahead.has_value(); });
  // So near it does not even draw back: who knows where the hand goes.
  if (before < (stays ? kFromPeople : kAtPeople)) return true;
  return ComesNearer(here, way, before, distance);
}

bool ArmPlanner::IsHandNear(const Vector3d& p_W) const {
  return std::ranges::any_of(hands_.points(), [&](const Vector3d& p) {
    return (p - p_W).norm() < kFromHands;
  });
}

// ---- what is within reach

std::vector<std::string> ArmPlanner::Reachable() const {
  std::vector<std::string> reachable;
  for (const std::string& part : reachable_) {
    if (poses_.contains(part) && !IsInHand(part)) reachable.push_back(part);
  }
  return reachable;
}

bool ArmPlanner::IsGraspable(const std::string& part, const Isometry3d& X_WO) {
  bare_.PutPart(part, X_WO);
  OrReason<GraspChoice> planned = "";
  TriedWays tried(arm_);
  for (const size_t most : {kBestFew, kAll}) {
    const auto grasps = GraspsIn(bare_, part, std::nullopt, arm_.home, most);
    if (std::holds_alternative<std::string>(grasps)) continue;
    const auto plan = [&](const GraspChoice& grasp) {
      return PlanWay(bare_, arm_.name, {arm_.home, grasp.grip, grasp.opening},
                     grasp.q_approach, params_.settings.motion);
    };
    FindWay(std::get<std::vector<GraspChoice>>(grasps), &tried, plan, &planned);
    if (std::holds_alternative<GraspChoice>(planned)) break;
  }
  bare_.RemovePart(part);
  return std::holds_alternative<GraspChoice>(planned);
}

void ArmPlanner::RefreshReachable() {
  for (const auto& [name, X_WO] : poses_) {
    if (params_.parts.Find(name)->is_fixed) continue;
    const auto known = looked_at_.find(name);
    if (known != looked_at_.end() && !HasMoved(known->second, X_WO)) continue;
    looked_at_.insert_or_assign(name, X_WO);
    const auto at = std::ranges::lower_bound(reachable_, name);
    const bool was = at != reachable_.end() && *at == name;
    const bool is = IsGraspable(name, X_WO);
    if (is && !was) reachable_.insert(at, name);
    if (!is && was) reachable_.erase(at);
    return;
  }
}

}  // namespace cell::robot_arm
