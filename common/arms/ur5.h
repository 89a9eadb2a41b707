#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

#include "common/layout/arm_layout.h"

/// Kinematics of the Universal Robots UR5, from its published Denavit-
/// Hartenberg parameters. Frames: B of the base, 1 to 6 of the links, each
/// behind its joint; 6 is the flange F. Joints in rad, lengths in m.
namespace cell::ur5 {

inline constexpr double kJointLimit = 6.283185307179586;  ///< [rad] either way
inline constexpr double kJointSpeed = 3.141592653589793;  ///< [rad/s]

/// X_B1 to X_B6.
std::array<Eigen::Isometry3d, 6> LinkPoses(const Joints& q);
/// X_BF.
Eigen::Isometry3d FlangePose(const Joints& q);

/// V_BF = J q': [angular; linear] velocity of the flange in B's axes.
Eigen::Matrix<double, 6, 6> Jacobian(const Joints& q);

/// All joints in (-pi, pi] that bring the flange to X_BF, up to 8.
std::vector<Joints> Inverse(const Eigen::Isometry3d& X_BF);

/// `q` with each joint turned by whole turns next to `seed`, within limits.
Joints Nearest(const Joints& q, const Joints& seed);

/// The joints for X_BF that go on from `seed`: no joint jumps by more than
/// `max_step` [rad]. Nothing if there are none.
std::optional<Joints> InverseNear(const Eigen::Isometry3d& X_BF,
                                  const Joints& seed, double max_step);

/// How far from a singularity a straight motion is, 0 at one: the least of
/// |sin q3|, |sin q5| and the distance of the wrist's centre from the shoulder
/// axis in units of 0.46 m.
double Dexterity(const Joints& q);

}  // namespace cell::ur5
