#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"

namespace cell {

/// The posture of an arm: its joints, and where its hand places its fingers.
struct ArmPosture {
  Joints q = Joints::Zero();
  std::string grip = "two_finger_pinch";  ///< of HandType
  double opening = 0;                     ///< [m]
};

/// At home, the hand half open.
ArmPosture HomePosture(const ArmLayout& arm);

/// The shapes of an arm and its hand, by name and in this order:
/// "arm_<name>.plinth" (from the table to the base), "arm_<name>.base",
/// "arm_<name>.link_1" .. "link_6" in the frames 1..6 of ArmModel, then
/// "<gripper>.<box>" of the hand, each with its middle in its frame.
std::vector<Part> BodyPartsOf(const ArmLayout& arm);

/// The boxes of a hand alone, "<hand>.<box>".
std::vector<Part> HandPartsOf(const std::string& hand, const HandType& type);

/// X_WB of the bodies of BodyPartsOf(), in its order.
/// @throws std::invalid_argument if the hand has no such grip.
std::vector<Eigen::Isometry3d> BodyPosesOf(const ArmLayout& arm,
                                           const ArmPosture& posture);

/// The same by name, for drawing.
std::map<std::string, Eigen::Isometry3d> NamedBodyPosesOf(
    const ArmLayout& arm, const ArmPosture& posture);

/// The box that the fixed parts stand on, "pedestal", in its frame P.
Part PedestalBody(const CellLayout::Pedestal& pedestal);

/// X_WG of an arm.
Eigen::Isometry3d GripperPose(const ArmLayout& arm, const Joints& q);
/// X_BF that brings the gripper to X_WG.
Eigen::Isometry3d FlangePoseFor(const ArmLayout& arm,
                                const Eigen::Isometry3d& X_WG);

}  // namespace cell
