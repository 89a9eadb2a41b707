#pragma once

#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/arms/arm_bodies.h"
#include "common/geometry/part_shape.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"

namespace cell {

/// How an arm and its fingers stand.
struct ArmPosture {
  Joints q = Joints::Zero();
  std::string grip;
  double opening = 0;  ///< [m]
};

/// What an arm moves among: parts, table, pedestal, the other arms, itself.
/// Says whether a posture is free. Shapes are made once; a question costs some
/// ten microseconds.
class ArmScene {
 public:
  struct Held {
    std::string part;
    Eigen::Isometry3d X_GO = Eigen::Isometry3d::Identity();
  };
  /// What is asked of a posture.
  struct Question {
    double clearance = 0;      ///< [m] to everything ...
    double over_table = -1;    ///< [m] ... but the table; negative: to it, too
    std::optional<Held> held;  ///< moves with the gripper
    std::string grasped;       ///< part that the hand may touch
    bool is_seated = false;    ///< the held part may touch parts and pedestal
    bool only_fixed = false;   ///< parts and arms that can move do not count
  };

  ArmScene(const CellLayout& layout, const PartTable& parts,
           const std::string& arm);

  /// Parts without a pose are not there.
  void SetParts(const std::map<std::string, Eigen::Isometry3d>& poses);
  void SetOther(const std::string& arm, const ArmPosture& posture);
  /// The first two bodies found nearer than the clearance, in plain words;
  /// nothing if the posture is free.
  std::optional<std::string> WhyNot(const ArmPosture& posture,
                                    const Question& question) const;

  const ArmLayout& arm() const { return *arm_; }
  const std::map<std::string, Eigen::Isometry3d>& poses() const {
    return poses_;
  }

 private:
  struct Body {
    std::string name;
    PartShape shape;
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
    bool is_there = true;
    bool is_fixed = true;
  };
  struct Moving {
    const std::string* name;
    const PartShape* shape;
    Eigen::Isometry3d X_WB;
  };

  void AddOther(const ArmLayout& arm);
  std::optional<std::string> HitBy(const Moving& moving, bool is_hand,
                                   const Question& question) const;
  std::optional<std::string> HitsItself(const std::vector<Moving>& links,
                                        const std::vector<Moving>& tool,
                                        double clearance) const;

  CellLayout layout_;
  const ArmLayout* arm_;
  std::vector<Body> links_, boxes_;  // of the arm, in their own order
  std::vector<Body> parts_;
  std::vector<Body> fixtures_;                       // pedestal, other plinths
  std::map<std::string, std::vector<Body>> others_;  // by arm
  std::map<std::string, Eigen::Isometry3d> poses_;
};

}  // namespace cell
