#include "services/robot_arm/tool_kinematics.h"

#include "common/arms/ur5.h"

namespace cell {
namespace {
constexpr double kMaxStep = 0.3;  // [rad] of a joint from tick to tick
}  // namespace

ToolKinematics::ToolKinematics(const ArmLayout& layout) : layout_(layout) {}

Eigen::Isometry3d ToolKinematics::GripperPose(const Joints& q) const {
  return layout_.X_WB * ur5::FlangePose(q) * layout_.X_FG;
}

Eigen::Isometry3d ToolKinematics::SensorPose(const Joints& q) const {
  return layout_.X_WB * ur5::FlangePose(q) * layout_.X_FS.value();
}

std::optional<Joints> ToolKinematics::JointsNear(const Eigen::Isometry3d& X_WG,
                                                 const Joints& q) const {
  return ur5::InverseNear(
      layout_.X_WB.inverse() * X_WG * layout_.X_FG.inverse(), q, kMaxStep);
}

}  // namespace cell
