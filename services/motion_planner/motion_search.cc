#include "services/motion_planner/motion_search.h"

#include <utility>

#include "services/motion_planner/request_search.h"

namespace cell::motion_planner {

MotionSearch::MotionSearch(Params params)
    : params_(std::move(params)), empty_(params_.parts, params_.layout) {}

MotionPlan MotionSearch::Find(const MotionRequest& request) const {
  using Kind = MotionRequest::Kind;
  if (request.kind == Kind::kReach) return FindReachable(request);
  const RequestSearch search(params_, request, SceneOf(request));
  MotionPlan plan;
  switch (request.kind) {
    case Kind::kGrasp:
      plan = search.FindGrasp();
      break;
    case Kind::kPlace:
      plan = search.FindPlacement(*request.target);
      break;
    case Kind::kSetDown:
      plan = search.FindSetDown();
      break;
    case Kind::kWay:
      plan = search.FindWay(request.arms.at(request.arm).posture, request.goal);
      break;
    case Kind::kReach:
      break;
  }
  plan.id = request.id;
  plan.arm = request.arm;
  return plan;
}

ArmScene MotionSearch::SceneOf(const MotionRequest& request) const {
  ArmScene scene = empty_;
  scene.PutParts(request.parts);
  for (const auto& [name, arm] : request.arms) {
    if (name != request.arm) scene.SetPosture(name, arm.posture);
    if (arm.held) scene.Hold(name, arm.held->part, arm.held->X_GO);
  }
  return scene;
}

/// Each part alone among what is fixed.
MotionPlan MotionSearch::FindReachable(const MotionRequest& request) const {
  MotionPlan plan;
  plan.id = request.id;
  plan.arm = request.arm;
  MotionRequest one;
  one.kind = MotionRequest::Kind::kGrasp;
  one.arm = request.arm;
  one.arms[one.arm].posture = HomePosture(*params_.layout.FindArm(one.arm));
  ArmScene fixed = empty_;
  for (const auto& [name, X_WO] : request.parts) {
    if (params_.parts.Find(name)->is_fixed) fixed.PutPart(name, X_WO);
  }
  for (const std::string& part : request.wanted) {
    ArmScene scene = fixed;
    scene.PutPart(part, request.parts.at(part));
    one.part = part;
    if (RequestSearch(params_, one, std::move(scene)).FindGrasp()) {
      plan.reachable.push_back(part);
    }
  }
  return plan;
}

}  // namespace cell::motion_planner
