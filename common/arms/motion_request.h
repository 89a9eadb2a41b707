#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/arms/arm_scene.h"
#include "common/arms/reach.h"

namespace cell {

/// Asks a planner of motions where an arm can go. A value: the answer is a
/// function of it.
struct MotionRequest {
  enum class Kind : int8_t {
    kGrasp = 0,    ///< of `part`; with a target, so that it can be placed there
    kPlace = 1,    ///< what is held, to the target
    kSetDown = 2,  ///< what is held, upright on a free place in `area`
    kWay = 3,      ///< to the joints `goal`
    /// Which of the parts `wanted` could be taken where they lie, from home, if
    /// all movable parts near it were gone.
    kReach = 4
  };
  struct Arm {
    ArmPosture posture;
    std::optional<ArmScene::Held> held;
  };

  int64_t id = 0;
  std::string arm;
  Kind kind = Kind::kWay;
  std::map<std::string, Arm> arms;                 ///< `arm` is one of them
  std::map<std::string, Eigen::Isometry3d> parts;  ///< X_WO where they are seen
  std::string part;
  std::vector<std::string> wanted;
  std::optional<PlaceTarget> target;
  Eigen::AlignedBox2d area{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  bool is_for_other_arm = false;  ///< kSetDown: the other arm takes it next
  Joints goal = Joints::Zero();
};

/// The answer: a free way, or why there is none.
struct MotionPlan {
  int64_t id = 0;  ///< of the request
  std::string arm;
  std::string reason;             ///< why there is none; empty if there is one
  std::vector<Joints> waypoints;  ///< from the posture on; none of kReach
  std::vector<std::string> reachable;  ///< of kReach
  GraspChoice grasp;                   ///< of kGrasp
  PlaceTarget target;                  ///< of kPlace and kSetDown
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();  ///< a like place

  explicit operator bool() const { return reason.empty(); }
};

}  // namespace cell
