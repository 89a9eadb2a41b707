#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/kinematics/arm_model.h"

namespace cell {

/// Joint angles or speeds as messages carry them, of any number; nothing if
/// they are not those of kNumJoints.
std::optional<Joints> JointsFromMessage(const std::vector<double>& values);

/// Sets `num_joints` of a message, and one of its fields.
void ToMessage(const Joints& q, int32_t* num_joints,
               std::vector<double>* values);

}  // namespace cell
