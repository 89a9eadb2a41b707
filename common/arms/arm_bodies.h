#pragma once

#include <Eigen/Geometry>
#include <string>
#include <utility>
#include <vector>

#include "common/layout/arm_layout.h"
#include "common/parts/part_table.h"

namespace cell {

/// Where a body is: its name and X_WB.
using NamedPose = std::pair<std::string, Eigen::Isometry3d>;

/// The plinth, the base and the six links of an arm as shapes in their frames:
/// "arm_<name>.plinth", ".base", ".link_1" to ".link_6". A little larger than
/// a UR5 is.
std::vector<Part> ArmLinks(const ArmLayout& arm);
/// Where they are, in the same order.
std::vector<NamedPose> ArmLinkPoses(const ArmLayout& arm, const Joints& q);

/// The boxes of a hand as shapes: "<hand>.<box>".
std::vector<Part> HandBoxes(const std::string& hand, const HandType& type);
/// Where they are, in the same order.
std::vector<NamedPose> HandBoxPoses(const std::string& hand,
                                    const HandType& type,
                                    const Eigen::Isometry3d& X_WG,
                                    const std::string& grip, double opening);

}  // namespace cell
