#pragma once

#include <map>
#include <string>

#include "common/arms/motion_messages.h"
#include "services/motion_planner/motion_search.h"
#include "tests/unit/stage_testing.h"

namespace cell {

/// The shipped cell with a fixed base and the parts that a test puts there, and
/// a search for ways in it.
class ShippedMotions {
 public:
  using Kind = MotionRequest::Kind;

  // Upright on the table.
  Eigen::Isometry3d Standing(const std::string& part, double x,
                             double y) const {
    const double bottom = Shape(part).LowestZ(Eigen::Isometry3d::Identity());
    return Eigen::Isometry3d(Eigen::Translation3d(x, y, 0.0005 - bottom));
  }
  PartShape Shape(const std::string& part) const {
    return PartShape(*task.parts.Find(part));
  }
  const ArmLayout& Arm(const std::string& name) const {
    return *task.layout.FindArm(name);
  }
  /// Of an arm that stands so, among the parts alone.
  MotionRequest Request(Kind kind, const std::string& arm,
                        const ArmPosture& posture) const {
    MotionRequest request;
    request.arm = arm;
    request.kind = kind;
    request.arms[arm].posture = posture;
    request.parts = poses;
    return request;
  }
  MotionRequest TakeRequest(const std::string& part,
                            const std::string& arm) const {
    MotionRequest request = Request(Kind::kGrasp, arm, HomePosture(Arm(arm)));
    request.part = part;
    return request;
  }
  bool IsReachable(const std::string& part, const std::string& arm) const {
    MotionRequest request = Request(Kind::kReach, arm, HomePosture(Arm(arm)));
    request.wanted = {part};
    return search.Find(request).reachable == request.wanted;
  }

  ShippedTask task;
  Config skills = ShippedDeployment().OfTask("skills.yaml");
  motion_planner::MotionSearch search{
      {task.layout, task.parts, MotionSettings::FromConfig(skills["motion"]),
       FingerSettings::FromConfig(skills["fingers"])}};
  std::map<std::string, Eigen::Isometry3d> poses = {
      {"base", task.layout.pedestal.X_WP}};
};

}  // namespace cell
