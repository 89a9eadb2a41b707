#pragma once

#include <string>
#include <vector>

#include "common/kinematics/arm_model.h"

namespace cell {

/// An arm of the UR family: six joints, the axes of 2, 3 and 4 parallel. Frames
/// 1 to 6 are those of its Denavit-Hartenberg table.
class UrArm final : public ArmModel {
 public:
  struct Params {
    std::string name;
    /// [m] Of the table, along (d) and across (a) the axes.
    double d1 = 0, a2 = 0, a3 = 0, d4 = 0, d5 = 0, d6 = 0;
    /// [m] Offsets of the upper arm and the forearm from the plane through axis
    /// 1 in which the wrist's centre would be without d4.
    double upper_arm_side = 0, forearm_side = 0;
    double base_radius = 0;  ///< [m]; the other housings scale with it
    JointLimits limits;
    double payload = 0;  ///< [kg]
  };

  explicit UrArm(Params params);

  const std::string& name() const override { return params_.name; }
  const JointLimits& limits() const override { return params_.limits; }
  double payload() const override { return params_.payload; }
  const Joints& levers() const override { return levers_; }
  const Joints& ready() const override;
  const Bodies& bodies() const override { return bodies_; }
  bool MayCollide(size_t body_a, size_t body_b) const override;
  LinkFrames LinkPoses(const Joints& q) const override;
  JacobianMatrix Jacobian(const Joints& q) const override;
  /// At most 8; free is angle 6, where the wrist is straight (sin q5 = 0).
  std::vector<Joints> SolveInverse(const Eigen::Isometry3d& X_BF,
                                   const Joints& seed) const override;
  /// The signs of what vanishes at a singularity: reach, elbow, wrist.
  IkConfiguration ConfigurationOf(const Joints& q) const override;
  bool IsNearSingularity(const Joints& q) const override;

  /// How far from singular. determinant = |det J| = |a2 a3 sin q3 sin q5
  /// reach|.
  struct Manipulability {
    double elbow = 0;           ///< sin q3
    double wrist = 0;           ///< sin q5
    double reach = 0;           ///< [m] of the wrist in front of axis 1
    double determinant = 0;     ///< [m^3]
    double wrist_distance = 0;  ///< [m] of the wrist's centre from axis 1
  };
  Manipulability ManipulabilityOf(const Joints& q) const;

  const Params& params() const { return params_; }

 private:
  struct DhRow {
    double d, a, sin_alpha, cos_alpha;
  };

  static Eigen::Isometry3d DhTransform(const DhRow& row, double angle);
  double ReachOf(const Joints& q) const;
  void SolvePlanar(const Eigen::Vector3d& p, double sum, Joints q,
                   std::vector<Joints>* solutions) const;

  Params params_;
  std::array<DhRow, kNumJoints> rows_;
  Joints levers_;
  double min_determinant_;     ///< [m^3] kept from singularities
  double min_wrist_distance_;  ///< [m] likewise
  Bodies bodies_;
};

}  // namespace cell
