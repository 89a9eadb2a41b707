#pragma once

#include <string>

#include "common/arms/arm_scene.h"
#include "common/arms/joint_trajectory.h"
#include "services/robot_arm/or_reason.h"
#include "services/robot_arm/skill_settings.h"

namespace cell::robot_arm {

/// A free way of an arm from how it stands in `from` to the joints `to`, with
/// its hand as it is: straight, or up, over and down, or else searched for. It
/// keeps the clearance wanted if that can be, may leave what it touches, and
/// stays within the workspace.
OrReason<JointTrajectory> PlanWay(const ArmScene& scene, const std::string& arm,
                                  const ArmPosture& from, const Joints& to,
                                  const SkillSettings::Motion& motion);

}  // namespace cell::robot_arm
