#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>

namespace cell::vtb {

/// Poses as MuJoCo keeps them: a position and a quaternion, w first.
Eigen::Isometry3d PoseFromMujoco(const mjtNum* position,
                                 const mjtNum* quat_wxyz);
void PoseToMujoco(const Eigen::Isometry3d& X, mjtNum* position,
                  mjtNum* quat_wxyz);

/// Makes a weld hold its second body at X_1O in its first one. It acts at
/// `centre` of the second body (in O).
void SetWeld(const Eigen::Isometry3d& X_1O, const Eigen::Vector3d& centre,
             mjModel& model, int equality);

}  // namespace cell::vtb
