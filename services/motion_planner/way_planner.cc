#include "services/motion_planner/way_planner.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/arms/straight_line.h"

namespace cell::motion_planner {
namespace {

constexpr double kViaHeight = 0.22;  // [m] that a way goes over things
constexpr double kReducedClearance =
    0.0015;                          // [m] if the clearance cannot be kept
constexpr double kTouching = 1e-4;   // [m]
constexpr int kMaxTouching = 12;     // pairs
constexpr double kMinStep = 0.0027;  // [m] of the fingertips between checks
constexpr double kSame = 1e-6;       // [m]

// Straight, or through one via, or through two.
std::optional<std::vector<Joints>> UpAndOver(const Joints& from,
                                             const Joints& to,
                                             const std::vector<Joints>& vias,
                                             const WhyBlockedAt& why_blocked,
                                             const PathPlannerParams& params) {
  const auto is_free = [&](const Joints& a, const Joints& b) {
    return !WhyEdgeBlocked(a, b, why_blocked, params);
  };
  if (why_blocked(to)) return std::nullopt;
  if (is_free(from, to)) return std::vector<Joints>{from, to};
  std::vector<Joints> before, after;
  for (const Joints& via : vias) {
    if (is_free(from, via)) before.push_back(via);
    if (is_free(via, to)) after.push_back(via);
  }
  for (const Joints& a : before) {
    for (const Joints& b : after) {
      if (a == b) return std::vector<Joints>{from, a, to};
    }
  }
  for (const Joints& a : before) {
    for (const Joints& b : after) {
      if (is_free(a, b)) return std::vector<Joints>{from, a, b, to};
    }
  }
  return std::nullopt;
}

std::vector<BodyPair> Touching(const ArmScene& scene, const std::string& arm,
                               const ArmPosture& posture) {
  ClearanceRule rule{kTouching, {}};
  for (int i = 0; i < kMaxTouching; ++i) {
    auto pair = scene.FindTooNear(arm, posture, rule);
    if (!pair) break;
    rule.allowed.push_back(*std::move(pair));
  }
  return rule.allowed;
}

// [m] of the gripper beyond where ways stay.
double OverBorder(const ArmLayout& arm, const Joints& q) {
  return arm.PlannedWorkspace().exteriorDistance(
      GripperPose(arm, q).translation());
}

}  // namespace

JointPath PlanWay(const ArmScene& scene, const std::string& arm,
                  const ArmPosture& from, const Joints& to,
                  const MotionSettings& motion) {
  const ArmLayout& layout = *scene.layout().FindArm(arm);
  std::vector<Joints> vias;
  for (const Joints& q : {from.q, to}) {
    if (const auto raised = RaisedBy(kViaHeight, layout, q)) {
      vias.push_back(*raised);
    }
  }
  vias.push_back(layout.home);
  // It may begin and end nearer to the border, but goes no further out.
  const double border =
      std::max(OverBorder(layout, from.q), OverBorder(layout, to));
  // A reduced clearance does not count towards other arms: an arm stops where
  // it would come nearer to them.
  const double to_others =
      scene.DistanceToOthers(arm, from, motion.clearance) - kSame;
  std::string reason;
  // The arm is already there: what is near must not keep it from leaving.
  for (const double clearance :
       {motion.clearance, kReducedClearance, kTouching}) {
    ClearanceRule rule{clearance, {}};
    if (clearance == kTouching) rule.allowed = Touching(scene, arm, from);
    const auto ask = AskScene(scene, arm, from, rule);
    const bool is_last = clearance == kTouching;
    if (!is_last && ask(from.q)) continue;
    PathPlannerParams params(*layout.model);
    params.tip_step = std::clamp(1.8 * clearance, kMinStep, params.tip_step);
    const auto why_blocked =
        [&](const Joints& q) -> std::optional<std::string> {
      if (q == from.q) return std::nullopt;
      if (OverBorder(layout, q) > border) {
        return "the gripper would leave its workspace";
      }
      if (auto why = ask(q)) return why;
      const bool is_near_other =
          clearance < to_others &&
          scene.DistanceToOthers(arm, {q, from.grip, from.opening}, to_others) <
              to_others;
      if (is_near_other) return "another arm would be in the way";
      return std::nullopt;
    };
    if (auto waypoints = UpAndOver(from.q, to, vias, why_blocked, params)) {
      return *std::move(waypoints);
    }
    JointPath path = PlanPath(from.q, {to}, vias, why_blocked, params);
    if (path) return path;
    if (reason.empty()) reason = "there is no free path: " + path.reason();
  }
  return Reason{reason};
}

}  // namespace cell::motion_planner
