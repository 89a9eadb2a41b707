#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "common/arms/arm_scene.h"
#include "common/arms/straight_line.h"
#include "common/result/result.h"

namespace cell {

struct ReachParams {
  double approach = 0.080;     ///< [m] straight before a grasp
  double open_margin = 0.024;  ///< [m] wider than the part before a grasp
  double clearance = 0.002;    ///< [m] along the straight ways
  /// [m] A part may touch what is nearer than this to its place while it moves
  /// straight to that place or from it.
  double touching = 0.005;
  size_t max_choices = 8;  ///< the search ends with this number
  int free_turns =
      24;  ///< copies tried of a part that any turn leaves as it is
  StraightLineParams line;
};

/// One way to take a part.
struct GraspChoice {
  size_t grasp = 0;    ///< index in Part::grasps
  std::string grip;    ///< of the arm's HandType
  double opening = 0;  ///< [m] on the way there
  double width = 0;    ///< [m] closed on the part
  Eigen::Isometry3d X_OG = Eigen::Isometry3d::Identity();
  Joints q_approach = Joints::Zero();
  Joints q_grasp = Joints::Zero();
  double cost = 0;  ///< the smaller the better
};

/// One way to bring a held part to its target.
struct PlaceChoice {
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();  ///< a like target
  Joints q_approach = Joints::Zero();
  Joints q_place = Joints::Zero();
  Joints q_turned = Joints::Zero();  ///< after PlaceTarget::turn
  double cost = 0;
};

/// Where a held part is to go: along -way_out over `approach` to X_WO.
struct PlaceTarget {
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  Eigen::Vector3d way_out = Eigen::Vector3d::UnitZ();  ///< in W, unit
  double approach = 0.100;                             ///< [m]
  /// [rad] turned by afterwards about way_out, right-hand, by joint 6; what is
  /// screwed in goes -405 deg. Only placements with that much room are found,
  /// clear all around.
  double turn = 0;
};

/// To take a part so that it can be placed.
struct TransferChoice {
  GraspChoice grasp;
  PlaceChoice place;
  bool is_same_configuration = false;
};

/// Best first; if there is none, why, e.g. "out of reach".
template <class Choice>
using Choices = Result<std::vector<Choice>>;

/// The grasps and placements of an arm that are possible among the bodies of
/// the scene. Each is within the joint limits and the arm's workspace, regular,
/// without collision, and straight from approach to end. Near `seed` and far
/// from the limits is better.
class Reach {
 public:
  /// @throws std::invalid_argument if there is no such arm.
  Reach(const ArmScene& scene, const std::string& arm,
        const ReachParams& params = {});

  /// Of a part that stands in the scene. Every grasp of the table, and its copy
  /// turned by pi about z of G, for which the hand knows a grip and opens wide
  /// enough.
  Choices<GraspChoice> Grasps(const std::string& part,
                              const Joints& seed) const;
  /// Of a part held as X_GO by `grip` closed to `width`; symmetric parts may
  /// arrive in any way that looks the same.
  Choices<PlaceChoice> Placements(const std::string& part,
                                  const Eigen::Isometry3d& X_GO,
                                  const std::string& grip, double width,
                                  const PlaceTarget& target,
                                  const Joints& seed) const;
  /// Grasps that allow the placement, those in one configuration of the
  /// arm first; at most `max_choices`.
  Choices<TransferChoice> Transfers(const std::string& part,
                                    const PlaceTarget& target,
                                    const Joints& seed,
                                    size_t max_choices = 4) const;

 private:
  /// When the fingers close on the part.
  ClearanceRule Closing(const std::string& part, const std::string& grip) const;
  /// When the part, held, leaves X_WO or gets there.
  ClearanceRule Grazing(const std::string& part,
                        const Eigen::Isometry3d& X_WO) const;

  ArmScene scene_;
  std::string arm_name_;
  const ArmLayout* arm_;  ///< in the scene's layout
  ReachParams params_;
};

/// The target of a part at a site of a host at X_WH.
PlaceTarget TargetAt(const Site& site, const Eigen::Isometry3d& X_WH);

}  // namespace cell
