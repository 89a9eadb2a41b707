#pragma once

#include <Eigen/Geometry>
#include <array>
#include <numbers>
#include <vector>

#include "common/layout/arm_layout.h"

/// The kinematics of a UR5, from its published Denavit-Hartenberg table. Frames
/// B of its base and 1..6 after each joint; the last is the flange F.
namespace cell::ur5 {

inline constexpr double kJointLimit = 2 * std::numbers::pi;  ///< +- [rad]
inline constexpr double kSpeedLimit = std::numbers::pi;      ///< [rad/s]

/// [m] Along (d) and across (a) the axes.
inline constexpr double kD1 = 0.089159, kA2 = -0.425, kA3 = -0.39225,
                        kD4 = 0.10915, kD5 = 0.09465, kD6 = 0.0823;

using JacobianMatrix = Eigen::Matrix<double, 6, 6>;

/// X_B1 .. X_B6.
std::array<Eigen::Isometry3d, 6> LinkPoses(const Joints& q);
/// X_BF.
Eigen::Isometry3d FlangePose(const Joints& q);
/// V_BF = J dq: the flange's angular [rad/s], then linear velocity [m/s] in B.
JacobianMatrix Jacobian(const Joints& q);

/// Every solution of FlangePose(q) = X_BF, at most 8, angles in [-pi, pi].
/// Where the wrist is straight (sin q5 = 0) q6 is `q6_if_free`.
std::vector<Joints> SolveInverse(const Eigen::Isometry3d& X_BF,
                                 double q6_if_free = 0);

/// Each angle plus the whole turns that bring it nearest to the seed's, within
/// the limits.
Joints NearestTo(const Joints& seed, const Joints& q);
bool IsWithinLimits(const Joints& q);
/// [rad] To the nearest limit; negative beyond it.
double LimitMargin(const Joints& q);

/// Which of the 8 solutions: the signs of what vanishes at a singularity. Only
/// through one can a motion go from branch to branch.
struct Branch {
  bool is_reach_negative = false;
  bool is_elbow_negative = false;
  bool is_wrist_negative = false;
  bool operator==(const Branch&) const = default;
};
Branch BranchOf(const Joints& q);

/// How far from singular. |det J| = a2 a3 |sin q3 sin q5 reach|.
struct Regularity {
  double elbow = 0;           ///< sin q3
  double wrist = 0;           ///< sin q5
  double reach = 0;           ///< [m] of the wrist in front of axis 1
  double determinant = 0;     ///< |det J| [m^3]
  double wrist_distance = 0;  ///< [m] of the wrist's centre from axis 1
};
Regularity RegularityOf(const Joints& q);

/// Bounds for Cartesian motion; motion from joints to joints needs none.
struct RegularityBounds {
  double min_sine = 0.26;            ///< |sin q3|, |sin q5|: 15 deg
  double min_determinant = 0.010;    ///< [m^3]
  double min_wrist_distance = 0.12;  ///< [m]
};
bool IsRegular(const Joints& q, const RegularityBounds& bounds = {});

}  // namespace cell::ur5
