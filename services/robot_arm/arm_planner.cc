#include "services/robot_arm/arm_planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/arms/path_planner.h"
#include "common/arms/ur5.h"

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;

constexpr double kViaHeight = 0.22;    // [m] that a way goes over things
constexpr double kMoved = 0.002;       // [m] a part has moved
constexpr double kTurned = 0.01;       // [rad] or turned
constexpr double kFromHands = 0.25;    // [m] that people's hands are given
constexpr double kInHand = 0.015;      // [m] nearer than this a hand holds it
constexpr double kGrid = 0.03;         // [m] of the free places that are tried
constexpr double kOverTable = 0.0005;  // [m] a part is set down from
constexpr double kInside = 0.005;      // [m] a way stays inside the workspace

bool IsSame(const Isometry3d& a, const Isometry3d& b) {
  return (a.translation() - b.translation()).norm() < kMoved &&
         Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle() <
             kTurned;
}

Reach::Params ReachParams(const SkillSettings& settings) {
  Reach::Params params;
  params.approach = settings.motion.approach;
  params.open_margin = settings.fingers.open_margin;
  params.clearance = settings.motion.clearance;
  return params;
}

}  // namespace

ArmPlanner::ArmPlanner(const Params& params)
    : params_(params),
      arm_(*params_.layout.FindArm(params.arm)),
      scene_(params_.layout, params_.parts, params.arm),
      reach_(scene_, params_.parts, ReachParams(params_.settings)) {
  for (const Part& part : params_.parts.parts()) {
    const PartShape& shape =
        shapes_.emplace(part.name, PartShape(part)).first->second;
    bottoms_[part.name] = shape.LowestZ(Isometry3d::Identity());
  }
}

std::optional<ArmScene::Held> ArmPlanner::Held() const {
  if (!held_) return std::nullopt;
  return ArmScene::Held{held_->part, held_->X_GO};
}

OrReason<Pick> ArmPlanner::PlanPick(const std::string& part,
                                    const std::optional<PlaceGoal>& goal,
                                    const Joints& q) const {
  if (goal) return reach_.PickToPlace(part, *goal, q);
  auto picks = reach_.Picks(part, q);
  if (auto* reason = std::get_if<std::string>(&picks)) return *reason;
  return std::get<std::vector<Pick>>(picks).front();
}

OrReason<Place> ArmPlanner::PlanPlace(const PlaceGoal& goal,
                                      const Joints& q) const {
  auto places = reach_.Places(*Held(), held_->grip, held_->width, goal, q);
  if (auto* reason = std::get_if<std::string>(&places)) return *reason;
  return std::get<std::vector<Place>>(places).front();
}

/// [m] of the gripper beyond where ways stay.
double ArmPlanner::OverBorder(const Joints& q) const {
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kInside);
  const Eigen::AlignedBox3d inside(arm_.workspace.min() + margin,
                                   arm_.workspace.max() - margin);
  return inside.exteriorDistance(
      (arm_.X_WB * ur5::FlangePose(q) * arm_.X_FG).translation());
}

OrReason<JointTrajectory> ArmPlanner::PlanTransit(
    const Joints& from, const Joints& to, double opening,
    const std::string& grip) const {
  const SkillSettings::Motion& motion = params_.settings.motion;
  ArmScene::Question question{.clearance = motion.clearance, .held = Held()};
  std::string reason;
  // It may begin and end nearer to the border, but goes no further out.
  const double border = std::max(OverBorder(from), OverBorder(to));
  const auto is_free = [&](const Joints& q) {
    if (OverBorder(q) > border) return false;
    const auto hit = scene_.WhyNot({q, grip, opening}, question);
    if (hit && reason.empty()) reason = *hit;
    return !hit;
  };
  // Where it stands it stands: a touch there must not forbid to leave.
  if (!is_free(from)) {
    reason.clear();
    question.clearance = 0;
  }
  // Up, over, and down again.
  std::vector<Joints> via = {arm_.home};
  for (const Joints& q : {to, from}) {
    const Isometry3d X_BF = ur5::FlangePose(q);
    const Isometry3d X_WF = Translation3d(0, 0, kViaHeight) * arm_.X_WB * X_BF;
    const auto above = ur5::InverseNear(arm_.X_WB.inverse() * X_WF, q, 1.5);
    if (above) via.push_back(*above);
  }
  const auto path = PathPlanner({}).Find(from, to, via, is_free);
  if (!path) {
    return "there is no free way" + (reason.empty() ? "" : ": " + reason);
  }
  return JointTrajectory(*path,
                         {motion.transit_speed, motion.transit_acceleration});
}

OrReason<PlaceGoal> ArmPlanner::FindFreePlace(const Eigen::AlignedBox2d& area,
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
  PlaceGoal goal;
  goal.approach = params_.settings.motion.approach;
  goal.symmetry_order = 0;  // any way round will do
  goal.is_site = false;
  for (const Eigen::Vector2d& p : points) {
    goal.X_WO =
        Translation3d(p.x(), p.y(), kOverTable - bottoms_.at(held_->part));
    const auto planned = PlanPlace(goal, q);
    if (std::holds_alternative<Place>(planned)) return goal;
  }
  return "there is no free place on the table";
}

bool ArmPlanner::IsNearSomething(const Joints& q) const {
  return scene_
      .WhyNot({q, "", 0}, {.clearance = params_.settings.motion.clearance})
      .has_value();
}

void ArmPlanner::SetHands(std::vector<Eigen::Vector3d> points) {
  hands_ = PointCloud(std::move(points));
}

bool ArmPlanner::IsHandNear(const Eigen::Vector3d& p_W) const {
  return std::ranges::any_of(hands_.points(), [&](const Eigen::Vector3d& p) {
    return (p - p_W).norm() < kFromHands;
  });
}

std::vector<std::string> ArmPlanner::Reachable() const {
  std::vector<std::string> reachable;
  for (const std::string& part : reachable_) {
    const auto pose = scene_.poses().find(part);
    if (pose == scene_.poses().end()) continue;
    const bool is_in_hand =
        shapes_.at(part).DistanceTo(hands_, pose->second, kInHand) < kInHand;
    if (!is_in_hand) reachable.push_back(part);
  }
  return reachable;
}

void ArmPlanner::RefreshReachable() {
  for (const auto& [name, X_WO] : scene_.poses()) {
    if (params_.parts.Find(name)->is_fixed) continue;
    const auto known = looked_at_.find(name);
    if (known != looked_at_.end() && IsSame(known->second, X_WO)) continue;
    looked_at_.insert_or_assign(name, X_WO);
    const auto at = std::ranges::lower_bound(reachable_, name);
    const bool was = at != reachable_.end() && *at == name;
    const bool is = !std::holds_alternative<std::string>(
        reach_.Picks(name, arm_.home, true));
    if (is && !was) reachable_.insert(at, name);
    if (!is && was) reachable_.erase(at);
    return;
  }
}

}  // namespace cell
