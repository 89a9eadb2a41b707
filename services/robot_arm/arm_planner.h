#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/arms/arm_scene.h"
#include "common/arms/joint_trajectory.h"
#include "common/arms/reach.h"
#include "common/geometry/part_shape.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "services/robot_arm/or_reason.h"
#include "services/robot_arm/skill_settings.h"

namespace cell::robot_arm {

/// True if a part has moved between two looks by more than they differ.
bool HasMoved(const Eigen::Isometry3d& X_WO_before,
              const Eigen::Isometry3d& X_WO_now);

/// A part in the gripper.
struct HeldPart {
  std::string part;
  Eigen::Isometry3d X_GO = Eigen::Isometry3d::Identity();
  std::string grip;
  double width = 0;  ///< [m] between the fingers
};

/// Answers where an arm can go, in the scene as it is (section VIII-A); if only
/// other arms are in the way, as if they were at home: MeetsOther() tells when
/// to wait for them.
class ArmPlanner {
 public:
  struct Params {
    std::string arm;
    CellLayout layout;
    PartTable parts;
    SkillSettings settings;
  };
  explicit ArmPlanner(const Params& params);

  /// The scene from now on.
  void SetParts(const std::map<std::string, Eigen::Isometry3d>& poses);
  /// How another arm stands, and whether its fingers hold something. One that
  /// is not known is of no account.
  void SetOther(const std::string& arm, const ArmPosture& posture,
                bool is_gripping);
  void SetHeld(const std::optional<HeldPart>& held);
  /// Points on persons' hands [in W].
  void SetHands(std::vector<Eigen::Vector3d> points);
  /// The part that all fingers touch.
  std::optional<std::string> FindGrasped(const ArmPosture& posture) const;

  /// Grasps to which there is a way. With a target: so that the part can also
  /// be placed there.
  OrReason<GraspChoice> PlanPick(const std::string& part,
                                 const std::optional<PlaceTarget>& target,
                                 const Joints& q) const;
  /// Of what is held, to where there is a way.
  OrReason<PlaceChoice> PlanPlace(const PlaceTarget& target,
                                  const Joints& q) const;
  OrReason<JointTrajectory> PlanTransit(const Joints& from, const Joints& to,
                                        double opening,
                                        const std::string& grip) const;
  /// Who takes it next.
  enum class Taker { kAnyone, kOtherArm };
  /// A free place on the table within `area` [m, in W] to which it can put what
  /// it holds, upright, and from where `taker` can take it when all arms are at
  /// home; those next to the middle first.
  OrReason<PlaceTarget> FindFreePlace(const Eigen::AlignedBox2d& area,
                                      Taker taker, const Joints& q) const;
  /// Where its joints will be at some times ahead; nothing: about where they
  /// are.
  using WayAhead = std::vector<std::optional<Joints>>;
  /// True if it comes too near to another arm on its way from `now`; it keeps
  /// farther from one that moves.
  bool MeetsOther(const ArmPosture& now, const WayAhead& way) const;
  /// The same with people's hands at work - that move, or hold something - and
  /// what they hold. It also heeds them where it is, if it stays about there.
  bool MeetsPerson(const ArmPosture& now, const WayAhead& way) const;
  /// True if something is nearer than the clearance.
  bool IsNearSomething(const Joints& q) const;

  /// True if a person's hand is nearer to the point than people are given.
  bool IsHandNear(const Eigen::Vector3d& p_W) const;

  /// Parts that PlanPick would take where they lie, sorted: as of the last
  /// refresh, which looks at one part that has moved. Not those in a person's
  /// hand. What can be moved out of the way is not in the way.
  std::vector<std::string> Reachable() const;
  void RefreshReachable();

 private:
  /// What is known of another arm.
  struct Other {
    std::optional<Joints> q;  ///< when it was last seen
    bool is_moving = false;
    std::optional<ArmScene::Held> held;
  };

  /// Puts all where it is.
  void Arrange();
  template <class Plan>
  auto NowOrLater(const Plan& plan) const;
  OrReason<std::vector<GraspChoice>> GraspsIn(
      const ArmScene& scene, const std::string& part,
      const std::optional<PlaceTarget>& target, const Joints& q,
      size_t most) const;
  OrReason<std::vector<PlaceChoice>> PlacesIn(const ArmScene& scene,
                                              const PlaceTarget& target,
                                              const Joints& q,
                                              size_t most) const;
  OrReason<PlaceTarget> FreePlaceIn(const ArmScene& scene,
                                    const Eigen::AlignedBox2d& area,
                                    Taker taker, const Joints& q) const;
  bool CanOtherTake(const ArmScene& scene, const Eigen::Isometry3d& X_WO) const;
  bool IsGraspable(const std::string& part, const Eigen::Isometry3d& X_WO);
  bool IsInHand(const std::string& part) const;

  Params params_;
  const ArmLayout& arm_;
  ArmScene scene_;
  ArmScene bare_;  ///< other arms at home, nothing there that can be moved
  std::optional<HeldPart> held_;
  std::map<std::string, Other> others_;  ///< by arm
  std::map<std::string, Eigen::Isometry3d> poses_;
  std::map<std::string, Eigen::Isometry3d> looked_at_;  // where parts lay then
  std::vector<std::string> reachable_;
  PointCloud hands_{{}};
  bool is_hand_moving_ = false;
  std::vector<std::string> in_hands_;  // parts, in people's
  std::map<std::string, PartShape> shapes_;
};

}  // namespace cell::robot_arm
