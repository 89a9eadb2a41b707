#pragma once

#include "common/arms/arm_scene.h"
#include "common/arms/motion_request.h"
#include "common/arms/motion_settings.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"

namespace cell::motion_planner {

/// Finds where an arm can go, in the scene that a request describes (section
/// VIII-A); if only other arms are in the way, with these at home: the arm
/// itself decides when to wait for them. Pure.
class MotionSearch {
 public:
  struct Params {
    CellLayout layout;
    PartTable parts;
    MotionSettings motion;
    FingerSettings fingers;
  };
  explicit MotionSearch(Params params);
  MotionSearch(const MotionSearch&) = delete;
  MotionSearch& operator=(const MotionSearch&) = delete;

  /// @pre the request is whole and names parts and arms that there are
  /// (motion_messages.h).
  MotionPlan Find(const MotionRequest& request) const;
  const Params& params() const { return params_; }

 private:
  ArmScene SceneOf(const MotionRequest& request) const;
  MotionPlan FindReachable(const MotionRequest& request) const;

  Params params_;
  ArmScene empty_;  ///< fixed parts, arms at home
};

}  // namespace cell::motion_planner
