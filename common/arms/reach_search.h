#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "common/arms/arm_scene.h"
#include "common/arms/reach.h"

namespace cell {

/// One question to Reach: the straight ways that the arm's kinematics allow, in
/// order of cost, and why others are none.
class ReachSearch {
 public:
  template <class Choice>
  struct Candidate {
    Choice choice;
    std::vector<Joints> track;  ///< from the end of the way back to its begin
  };

  /// Refers to its arguments.
  ReachSearch(const ArmLayout& arm, const ReachParams& params)
      : arm_(arm), params_(params) {}

  /// Every grasp, each turned by 0 and pi, by each grip that the hand knows.
  std::vector<Candidate<GraspChoice>> ToGrasp(const Part& part,
                                              const Eigen::Isometry3d& X_WO,
                                              const Joints& seed);
  /// Every like target of a symmetric part.
  std::vector<Candidate<PlaceChoice>> ToPlace(const Part& part,
                                              const Eigen::Isometry3d& X_GO,
                                              const PlaceTarget& target,
                                              const Joints& seed);
  /// True if the arm may be in each posture of the track.
  bool IsFree(const ArmScene& scene, const std::vector<Joints>& track,
              const std::string& grip, double opening,
              const ClearanceRule& rule);

  /// Of the attempt that came farthest.
  const std::string& reason() const { return reason_; }

 private:
  enum class Stage { kGrip, kHand, kReach, kLimits, kRegular, kCollision };

  void Fail(Stage stage, const std::string& reason);
  bool Suits(const GraspChoice& choice);
  std::vector<std::vector<Joints>> Tracks(const Eigen::Isometry3d& X_WG_begin,
                                          const Eigen::Isometry3d& X_WG_end,
                                          const Joints& seed, double turn);
  bool FindRoom(Joints* q, double turn) const;

  const ArmLayout& arm_;
  const ReachParams& params_;
  Stage stage_ = Stage::kGrip;
  std::string reason_;
};

}  // namespace cell
