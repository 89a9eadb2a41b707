#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>

#include "common/parts/part_table.h"

namespace cell::robot_arm {

/// The site that holds the part where it is: the part is seated there, or the
/// site's thread has taken hold of it. An arm that grips such a part may let go
/// of it, and must not carry it off. nullptr if no site holds it, or if its
/// pose is not known. By poses [X_WO] alone.
const Site* FindHoldingSite(
    const std::string& part, const PartTable& parts,
    const std::map<std::string, Eigen::Isometry3d>& poses);

}  // namespace cell::robot_arm
