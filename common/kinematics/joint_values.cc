#include "common/kinematics/joint_values.h"

#include <fmt/format.h>

namespace cell {

Result<Joints> JointsFromMessage(const std::vector<double>& values,
                                 const ArmModel& model) {
  if (values.size() != kNumJoints) {
    return Reason{fmt::format("{} joints instead of the {} of a {}",
                              values.size(), kNumJoints, model.name())};
  }
  return Joints(values.data());
}

Result<Joints> AnglesFromMessage(const std::vector<double>& values,
                                 const ArmModel& model) {
  auto q = JointsFromMessage(values, model);
  if (!q || model.IsWithinLimits(*q)) return q;
  return Reason{"joints beyond the limits of a " + model.name()};
}

void ToMessage(const Joints& q, int32_t* num_joints,
               std::vector<double>* values) {
  *num_joints = kNumJoints;
  values->assign(q.begin(), q.end());
}

}  // namespace cell
