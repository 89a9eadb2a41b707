#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/arms/arm_scene.h"
#include "common/arms/motion_request.h"
#include "common/geometry/part_shape.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "services/robot_arm/safety_distances.h"

namespace cell::robot_arm {

/// A part in the gripper.
struct HeldPart {
  std::string part;
  Eigen::Isometry3d X_GO = Eigen::Isometry3d::Identity();
  std::string grip;
  double width = 0;  ///< [m] between the fingers
};

/// What is around an arm, as it was last seen: parts, the other arms, people's
/// hands. Says what is too near, cheaply enough for every tick (section
/// VIII-A).
class SceneMonitor {
 public:
  struct Params {
    std::string arm;
    CellLayout layout;
    PartTable parts;
    double clearance = 0.008;  ///< [m] of everything not to be touched
    SafetyDistances distances = {};
  };
  explicit SceneMonitor(Params params);
  SceneMonitor(const SceneMonitor&) = delete;
  SceneMonitor& operator=(const SceneMonitor&) = delete;

  /// The parts' poses [X_WO] from now on.
  void SetParts(const std::map<std::string, Eigen::Isometry3d>& poses);
  /// The posture of another arm, and whether its fingers hold something.
  /// Ignores an unknown arm.
  void SetOther(const std::string& arm, const ArmPosture& posture,
                bool is_gripping);
  void SetHeld(const std::optional<HeldPart>& held);
  /// Points on persons' hands [in W].
  void SetHands(std::vector<Eigen::Vector3d> points);

  const std::map<std::string, Eigen::Isometry3d>& poses() const {
    return poses_;
  }
  /// The part that all fingers touch.
  std::optional<std::string> FindGrasped(const ArmPosture& posture) const;
  /// The scene as a request for a way of the arm from `posture`.
  MotionRequest MakeRequest(MotionRequest::Kind kind,
                            const ArmPosture& posture) const;

  /// Where its joints will be at some times ahead; nothing: about where they
  /// are.
  using WayAhead = std::vector<std::optional<Joints>>;
  /// True if it comes too near to another arm on its way from `now`; it keeps
  /// farther from one that moves.
  bool WouldCollideWithArm(const ArmPosture& now, const WayAhead& way) const;
  /// The same with people's hands at work - that move, or hold something - and
  /// what they hold. Also if it stays about where it is.
  bool WouldCollideWithPerson(const ArmPosture& now, const WayAhead& way) const;
  /// True if something is nearer than the clearance.
  bool IsNearSomething(const Joints& q) const;
  /// True if a person's hand is nearer to the point than people are given.
  bool IsHandNear(const Eigen::Vector3d& p_W) const;
  bool IsInHand(const std::string& part) const;

 private:
  /// What is known of another arm.
  struct Other {
    std::optional<Joints> q;  ///< when it was last seen
    bool is_moving = false;
    std::optional<ArmScene::Held> held;
  };

  /// Puts everything where it is.
  void Arrange();

  Params params_;
  const ArmLayout& arm_;
  ArmScene scene_;
  std::optional<HeldPart> held_;
  std::map<std::string, Other> others_;  ///< by arm
  std::map<std::string, Eigen::Isometry3d> poses_;
  PointCloud hands_{{}};
  bool is_hand_moving_ = false;
  std::vector<std::string> in_hands_;  ///< parts, in people's
  std::map<std::string, PartShape> shapes_;
};

}  // namespace cell::robot_arm
