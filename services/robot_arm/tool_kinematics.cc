#include "services/robot_arm/tool_kinematics.h"

#include "common/arms/arm_bodies.h"

namespace cell::robot_arm {
namespace {
constexpr double kMaxStep = 0.3;  // [rad] of a joint from tick to tick
}  // namespace

ToolKinematics::ToolKinematics(const ArmLayout& layout) : layout_(layout) {}

Eigen::Isometry3d ToolKinematics::GripperPose(const Joints& q) const {
  return cell::GripperPose(layout_, q);
}

Eigen::Isometry3d ToolKinematics::SensorPose(const Joints& q) const {
  return layout_.X_WB * layout_.model->FlangePose(q) * layout_.X_FS.value();
}

std::optional<Joints> ToolKinematics::JointsNear(const Eigen::Isometry3d& X_WG,
                                                 const Joints& q) const {
  std::optional<Joints> nearest;
  double least = kMaxStep;
  for (const Joints& solution :
       layout_.model->SolveInverse(FlangePoseFor(layout_, X_WG), q)) {
    const Joints near = layout_.model->NearestTo(q, solution);
    const double jump = (near - q).cwiseAbs().maxCoeff();
    if (jump > least || !layout_.model->IsWithinLimits(near)) continue;
    least = jump;
    nearest = near;
  }
  return nearest;
}

}  // namespace cell::robot_arm
