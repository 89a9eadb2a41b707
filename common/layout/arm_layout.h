#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "common/config/config.h"
#include "common/kinematics/arm_model.h"
#include "common/layout/hand_type.h"

namespace cell {

/// One arm of the cell and what it carries: cell.yaml's `arms`. Frames:
/// B of its base, F of the flange (z out of it), S of the force-torque sensor,
/// G of the gripper (Grasp: approach along -z, fingers close along x).
struct ArmLayout {
  std::string name;     ///< "right": its channels end in _RIGHT
  std::string gripper;  ///< the name of its hand among all hands
  HandType hand;
  std::shared_ptr<const ArmModel> model;  ///< never null
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  /// Joints that have G at cell.yaml's `home`, in the configuration of the
  /// model's ready(): whole tenths of a degree, the same on every machine.
  Joints home = Joints::Zero();
  Eigen::Isometry3d X_FG = Eigen::Isometry3d::Identity();
  /// Of arms in each other's way the one with the lowest goes first.
  int precedence = 1;
  /// Nothing: there is no sensor.
  std::optional<Eigen::Isometry3d> X_FS;
  double tool_mass = 0;                                ///< [kg] beyond S
  Eigen::Vector3d p_F_tool = Eigen::Vector3d::Zero();  ///< its centre of mass
  /// The origin of G stays within.
  Eigen::AlignedBox3d workspace;
  static constexpr double kInside = 0.005;  ///< [m] that is left to the servo
  /// Ways are planned within: kInside from the border.
  Eigen::AlignedBox3d PlannedWorkspace() const {
    const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kInside);
    return {workspace.min() + margin, workspace.max() - margin};
  }
  /// Parts are set down here, upright, for the other arm.
  Eigen::AlignedBox2d exchange;

  /// The arm called `name`. @throws ConfigError naming file:key.
  static ArmLayout FromConfig(const std::string& name, const Config& config,
                              const std::map<std::string, HandType>& types);
};

/// "RIGHT" of "right", for channel names.
std::string ChannelSuffix(const std::string& arm);

}  // namespace cell
