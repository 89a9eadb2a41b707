#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/arms/arm_scene.h"

namespace cell {

/// How an arm can take a part.
struct Pick {
  Eigen::Isometry3d X_OG = Eigen::Isometry3d::Identity();
  std::string grip;
  double width = 0;    ///< [m] between the fingers
  double opening = 0;  ///< [m] to come there with
  Joints q_approach = Joints::Zero(), q_grasp = Joints::Zero();
};

/// Where a held part is to go.
struct PlaceGoal {
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  Eigen::Vector3d way_out = Eigen::Vector3d::UnitZ();  ///< unit, in W
  double approach = 0;     ///< [m] along it, from where the way is straight
  int symmetry_order = 1;  ///< turns about z of O that make no difference
  /// [rad] that the part is turned by at the end, clockwise seen along -z of
  /// its O, by the last joint.
  double turn = 0;
  /// At a site: the part touches others there. Else it stands free.
  bool is_site = true;
};

/// How an arm can bring a part there.
struct Place {
  /// A turn about z of O that leaves the part as it is.
  Eigen::Isometry3d X_turn = Eigen::Isometry3d::Identity();
  Joints q_approach = Joints::Zero(), q_place = Joints::Zero();
};

/// Answers what an arm can take and where it can bring it: by every grasp of
/// the part, turned and unturned, in every branch of the inverse kinematics,
/// along straight ways within limits, among what is there.
class Reach {
 public:
  struct Params {
    double approach = 0.10;          ///< [m] straight way to a grasp
    double open_margin = 0.014;      ///< [m] each finger, beyond the part
    double clearance = 0.008;        ///< [m] on the way
    double near_clearance = 0.0015;  ///< [m] at a grasp or a site
    double apart = 0.012;            ///< [m] around a part that is set down
    double dexterity = 0.2;          ///< least one, on straight ways
  };
  template <class T>
  using OrReason = std::variant<T, std::string>;

  /// All must outlive this object.
  Reach(const ArmScene& scene, const PartTable& parts, const Params& params)
      : scene_(scene), parts_(parts), params_(params) {}

  /// All ways to take the part, those with the least way from `seed` first, or
  /// why there is none.
  OrReason<std::vector<Pick>> Picks(const std::string& part, const Joints& seed,
                                    bool only_fixed = false) const;
  /// The same for placing what is held with X_GO.
  OrReason<std::vector<Place>> Places(const ArmScene::Held& held,
                                      const std::string& grip, double width,
                                      const PlaceGoal& goal,
                                      const Joints& seed) const;
  /// The best way to take the part from which it can also be placed.
  OrReason<Pick> PickToPlace(const std::string& part, const PlaceGoal& goal,
                             const Joints& seed) const;

 private:
  struct Ways;
  std::optional<Joints> FollowLine(const Joints& q,
                                   const Eigen::Isometry3d& X_WG_from,
                                   const Eigen::Isometry3d& X_WG_to) const;
  std::vector<Joints> Solutions(const Eigen::Isometry3d& X_WG,
                                const Joints& seed) const;

  const ArmScene& scene_;
  const PartTable& parts_;
  Params params_;
};

}  // namespace cell
