#pragma once

#include <string>

#include "common/arms/arm_scene.h"
#include "common/arms/motion_settings.h"
#include "common/arms/path_planner.h"

namespace cell::motion_planner {

/// A collision-free path of an arm from its posture in `from` to the joints
/// `to`, with its hand unchanged: straight, or up, over and down, or else
/// searched for. It keeps the wanted clearance if possible, may leave what it
/// touches, and stays within the workspace.
JointPath PlanWay(const ArmScene& scene, const std::string& arm,
                  const ArmPosture& from, const Joints& to,
                  const MotionSettings& motion);

}  // namespace cell::motion_planner
