#pragma once

#include <string>

#include "common/arms/arm_scene.h"
#include "common/arms/motion_settings.h"
#include "common/arms/path_planner.h"

namespace cell::motion_planner {

/// A free way of an arm from how it stands in `from` to the joints `to`, with
/// its hand as it is: straight, or up, over and down, or else searched for. It
/// keeps the clearance wanted if that can be, may leave what it touches, and
/// stays within the workspace.
JointPath PlanWay(const ArmScene& scene, const std::string& arm,
                  const ArmPosture& from, const Joints& to,
                  const MotionSettings& motion);

}  // namespace cell::motion_planner
