#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cell/truth_poses_t.hpp"
#include "common/geometry/part_shape.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "services/cell/scoring/arm_activity.h"

namespace cell::cli {

/// Which bodies of arms, hands and held parts touch what they must not: any
/// contact but the grasp and the intended insertion. Persons' hands do not
/// count.
class CollisionCheck {
 public:
  struct Touch {
    std::string arm;
    std::string first;  ///< of the arm, or what it holds
    std::string second;
    /// `second` is a person's hand: either may have hit the other.
    bool is_by_person = false;
  };

  CollisionCheck(const CellLayout& layout, const PartTable& parts);

  /// Bodies are at `poses`; `activities`: of arms, by name.
  std::vector<Touch> Look(const truth_poses_t& poses,
                          const std::map<std::string, ArmActivity>& activities);

 private:
  struct Body {
    std::string name;
    PartShape shape;
    Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
    bool is_there = false;
  };
  /// Of an arm, as indices of bodies: as in BodyPartsOf().
  struct Arm {
    std::string name;
    size_t plinth = 0, first_link = 0, first_box = 0, end = 0;
    std::shared_ptr<const ArmModel> model;
  };

  void Add(const Part& shape);
  void Pose(const truth_poses_t& poses);
  bool Touches(size_t a, size_t b) const;
  bool TouchesTable(size_t body) const;
  void LookAround(const Arm& arm, size_t body, const std::string& grasped);
  void LookAtItself(const Arm& arm);
  void LookAtHeld(const Arm& arm, const ArmActivity& activity);
  void Report(const Arm& arm, size_t first, size_t second);
  bool IsInPersonsHand(size_t part) const;

  std::vector<Body> bodies_;  // parts, the pedestal, arms, persons' hands
  std::map<std::string, size_t> indices_;
  size_t num_parts_ = 0;
  size_t pedestal_ = 0;
  std::vector<Arm> arms_;
  size_t first_of_hands_ = 0;   // persons'
  std::vector<Touch> touches_;  // of this look
};

}  // namespace cell::cli
