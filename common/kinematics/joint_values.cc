#include "common/kinematics/joint_values.h"

namespace cell {

std::optional<Joints> JointsFromMessage(const std::vector<double>& values) {
  if (values.size() != kNumJoints) return std::nullopt;
  return Joints(values.data());
}

void ToMessage(const Joints& q, int32_t* num_joints,
               std::vector<double>* values) {
  *num_joints = kNumJoints;
  values->assign(q.begin(), q.end());
}

}  // namespace cell
