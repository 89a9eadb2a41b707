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
constexpr double kGrid = 0.05;         // [m] of the free places that are tried
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
    bottoms_[part.name] = PartShape(part).LowestZ(Isometry3d::Identity());
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

OrReason<PlaceGoal> ArmPlanner::Upright(const std::string& part,
                                        const Isometry3d& X_WT) const {
  PlaceGoal goal;
  goal.X_WO = X_WT * Translation3d(0, 0, kOverTable - bottoms_.at(part));
  goal.approach = params_.settings.motion.approach;
  goal.symmetry_order = 0;  // any way round will do
  return goal;
}

OrReason<PlaceGoal> ArmPlanner::FindFreePlace(const Joints& q) const {
  const CellLayout::PartsArea& area = params_.layout.parts_area;
  for (double y = -area.size.y() / 2; y <= area.size.y() / 2; y += kGrid) {
    for (double x = -area.size.x() / 2; x <= area.size.x() / 2; x += kGrid) {
      const Isometry3d X_WT(
          Translation3d(area.centre.x() + x, area.centre.y() + y, 0));
      const PlaceGoal goal = std::get<PlaceGoal>(Upright(held_->part, X_WT));
      if (IsFree(goal) &&
          !std::holds_alternative<std::string>(PlanPlace(goal, q))) {
        return goal;
      }
    }
  }
  return "there is no free place on the table";
}

/// No part stands there.
bool ArmPlanner::IsFree(const PlaceGoal& goal) const {
  constexpr double kApart = 0.16;  // [m] of origins
  for (const auto& [name, X_WO] : scene_.poses()) {
    const Eigen::Vector3d apart = X_WO.translation() - goal.X_WO.translation();
    if (name != held_->part && apart.head<2>().norm() < kApart) return false;
  }
  return true;
}

bool ArmPlanner::IsNearSomething(const Joints& q) const {
  return scene_
      .WhyNot({q, "", 0}, {.clearance = params_.settings.motion.clearance})
      .has_value();
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
