#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/kinematics/arm_model.h"

namespace cell {

/// The kind of arm with this name; null if there is none. The same object for
/// the same name.
std::shared_ptr<const ArmModel> FindArmModel(const std::string& name);

/// Of all that there are, sorted.
std::vector<std::string> ArmModelNames();

}  // namespace cell
