#pragma once

#include <cstdint>
#include <vector>

#include "common/kinematics/arm_model.h"
#include "common/result/result.h"

namespace cell {

/// Joint angles or speeds as messages carry them, of any number; a reason like
/// "7 joints instead of the 6 of a ur5" if they are not the arm's.
Result<Joints> JointsFromMessage(const std::vector<double>& values,
                                 const ArmModel& model);
/// The same of angles; a reason, too, if they lie beyond the arm's limits.
Result<Joints> AnglesFromMessage(const std::vector<double>& values,
                                 const ArmModel& model);

/// Sets `num_joints` of a message, and one of its fields.
void ToMessage(const Joints& q, int32_t* num_joints,
               std::vector<double>* values);

}  // namespace cell
