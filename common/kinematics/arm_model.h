#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/parts/piece.h"

namespace cell {

/// Axes of every arm that the cell plans for. Messages carry any number.
inline constexpr int kNumJoints = 6;

/// Joint angles [rad] of an arm, from the base to the flange.
using Joints = Eigen::Matrix<double, kNumJoints, 1>;

/// What the joints of an arm can do, each in either direction.
struct JointLimits {
  Joints angle = Joints::Zero();  ///< +- [rad]
  Joints speed = Joints::Zero();  ///< +- [rad/s]
};

/// Which of several solutions of the inverse kinematics. Only through a
/// singularity can a motion go from one configuration to another.
struct IkConfiguration {
  uint8_t index = 0;
  bool operator==(const IkConfiguration&) const = default;
};

/// A kind of arm: its kinematics, limits and bodies. Frames: B of its base, 1
/// to 6 after each joint; the last is the flange F, its z out of it. It does
/// not contain where the arm stands or what it carries (ArmLayout).
class ArmModel {
 public:
  using LinkFrames = std::array<Eigen::Isometry3d, kNumJoints>;
  using JacobianMatrix = Eigen::Matrix<double, 6, kNumJoints>;

  /// The housings of the arm, each a body of its own, as they are drawn and as
  /// they collide.
  struct Bodies {
    double base_radius = 0;                            ///< [m] of its foot
    std::vector<Piece> base;                           ///< in B
    std::array<std::vector<Piece>, kNumJoints> links;  ///< in 1 .. 6
  };

  /// Bodies by index, from the table outwards: the plinth, the base, links 1 to
  /// 6, then what the arm carries.
  static constexpr size_t kPlinthBody = 0, kBaseBody = 1, kFirstLinkBody = 2;
  static constexpr size_t kNumBodies = kFirstLinkBody + kNumJoints;

  virtual ~ArmModel() = default;

  virtual const std::string& name() const = 0;
  virtual const JointLimits& limits() const = 0;
  virtual double payload() const = 0;  ///< [kg] beyond the flange
  /// [m] By which the tip of a tool moves for each radian of each joint, about.
  virtual const Joints& levers() const = 0;
  /// A posture in the open, the flange down: arms are at home in its
  /// configuration.
  virtual const Joints& ready() const = 0;
  virtual const Bodies& bodies() const = 0;
  /// True if two bodies of one arm, by index, can hit each other: neighbours do
  /// not.
  virtual bool MayCollide(size_t body_a, size_t body_b) const = 0;

  /// X_B1 .. X_B6.
  virtual LinkFrames LinkPoses(const Joints& q) const = 0;
  /// V_BF = J dq: the flange's angular [rad/s], then linear velocity [m/s] in
  /// B.
  virtual JacobianMatrix Jacobian(const Joints& q) const = 0;
  /// Every solution of FlangePose(q) = X_BF, angles in [-pi, pi]; at a
  /// singularity that leaves an angle free, with that of the seed.
  virtual std::vector<Joints> SolveInverse(const Eigen::Isometry3d& X_BF,
                                           const Joints& seed) const = 0;
  virtual IkConfiguration ConfigurationOf(const Joints& q) const = 0;
  /// True where a Cartesian motion would want joints to turn too fast; motion
  /// from joints to joints needs no continuity.
  virtual bool IsNearSingularity(const Joints& q) const = 0;

  /// X_BF.
  Eigen::Isometry3d FlangePose(const Joints& q) const;
  /// The solution of FlangePose(q) = X_BF that is nearest to the seed, in its
  /// configuration. Nothing if there is none within the limits.
  std::optional<Joints> SolveNear(const Eigen::Isometry3d& X_BF,
                                  const Joints& seed) const;
  /// Each angle plus the whole turns that bring it nearest to the seed's,
  /// within the limits.
  Joints NearestTo(const Joints& seed, const Joints& q) const;
  /// [rad] To the nearest limit; negative beyond it.
  double LimitMargin(const Joints& q) const;
  /// False if an angle is not a number, too.
  bool IsWithinLimits(const Joints& q) const;
};

}  // namespace cell
