#pragma once

#include <string>

#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"

namespace cell::vtb {

/// Numbers of the physics model.
struct PhysicsParams {
  double dt = 0.001;  ///< [s] of a step; a tick is a whole number of them
  double friction = 0.3;
  /// [s] of the spring that holds a part in a hand: a person's wrist gives way.
  double grip_time_constant = 0.02;
  /// [N/m] of a gripper with its fingers and sensor, for what it holds.
  double gripper_stiffness = 20e3;
  double gripper_lead = 0.015;  ///< [s] damping of it, by its stiffness
  bool sleep = true;            ///< of parts at rest (SleepingBodies)
};

/// Names in the model. A hand is the boxes of CellLayout and an invisible
/// wrist that parts are welded to while they are held.
inline constexpr char kTableName[] = "table";
inline constexpr char kPedestalName[] = "pedestal";
inline constexpr char kWrist[] = ".wrist";

std::string GripName(const std::string& hand, const std::string& part);
/// Equalities of a thread between a site and a part: two points of the axis,
/// and the whole pose.
std::string ThreadPointName(const std::string& site, const std::string& part,
                            int point);
std::string ThreadFreezeName(const std::string& site, const std::string& part);

/// The cell as a MuJoCo model: a plane table, the pedestal with the fixed
/// parts, articulated parts on them, free parts, hands. Only pieces with a
/// contact class appear; masses come from the shapes. Every grip and thread is
/// an inactive equality.
/// @throws std::invalid_argument for more contact classes than mask bits.
std::string WorldXml(const PartTable& table, const CellLayout& layout,
                     const PhysicsParams& params);

}  // namespace cell::vtb
