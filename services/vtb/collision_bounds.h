#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <vector>

#include "services/vtb/oriented_box.h"

namespace cell::vtb {

/// Boxes around the shapes of a body that collide, with what each collides
/// with. Answers are never too far: a body that is near is found, one that is a
/// little further away may be.
class CollisionBounds {
 public:
  /// Of the model's shapes and masks as they are now.
  CollisionBounds(const mjModel& model, int body);

  /// [m] Of the farthest point from the body's origin O, or more.
  double reach() const { return reach_; }

  /// True if shapes of both that collide may be within `distance` [m].
  bool MayCollideWithin(double distance, const Eigen::Isometry3d& X_WO,
                        const CollisionBounds& other,
                        const Eigen::Isometry3d& X_WOther) const;
  /// True if any shape may be within `distance` [m] of a box in W.
  bool MayBeWithin(double distance, const Eigen::Isometry3d& X_WO,
                   const OrientedBox& box) const;

 private:
  struct Shape {
    OrientedBox box;  // in O
    int type = 0, affinity = 0;
  };

  std::vector<Shape> shapes_;
  OrientedBox hull_;  // of all shapes, along the axes of O
  double reach_ = 0;
};

}  // namespace cell::vtb
