#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "common/arms/arm_scene.h"
#include "common/arms/motion_request.h"
#include "common/arms/reach.h"
#include "services/motion_planner/motion_search.h"

namespace cell::motion_planner {

/// The search for one request in its scene. `params` and `request` must outlive
/// this object.
class RequestSearch {
 public:
  RequestSearch(const MotionSearch::Params& params,
                const MotionRequest& request, ArmScene scene);
  RequestSearch(const RequestSearch&) = delete;
  RequestSearch& operator=(const RequestSearch&) = delete;

  /// A grasp to which there is a way. With a target: so that the part can also
  /// be placed there.
  MotionPlan FindGrasp() const;
  /// Of what is held, to where there is a way.
  MotionPlan FindPlacement(const PlaceTarget& target) const;
  /// The same, to a free place; those next to the middle of the area first.
  MotionPlan FindSetDown() const;
  MotionPlan FindWay(const ArmPosture& from, const Joints& to) const;

 private:
  template <class Find>
  auto NowOrLater(const Find& find) const;
  Choices<GraspChoice> GraspsIn(const ArmScene& scene, size_t most) const;
  Choices<PlaceChoice> PlacesIn(const ArmScene& scene,
                                const PlaceTarget& target, size_t most) const;
  Result<PlaceTarget> FreePlaceIn(const ArmScene& scene) const;
  bool CanOtherTake(const ArmScene& scene, const Eigen::Isometry3d& X_WO) const;

  const MotionSearch::Params& params_;
  const MotionRequest& request_;
  ArmScene scene_;
  /// With the other arms at home; nothing if they are there.
  std::optional<ArmScene> later_;
  const ArmLayout& arm_;
  const MotionRequest::Arm& state_;  ///< of it
  ReachParams reach_;
};

}  // namespace cell::motion_planner
