#include "services/vtb/collision_bounds.h"

#include <algorithm>

#include "services/vtb/mujoco_pose.h"

namespace cell::vtb {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Isometry3d;
using Eigen::Vector3d;

AlignedBox3d MeshBox(const mjModel& model, int mesh) {
  AlignedBox3d box;
  const int begin = model.mesh_vertadr[mesh];
  for (int i = begin; i < begin + model.mesh_vertnum[mesh]; ++i) {
    box.extend(
        Eigen::Map<const Eigen::Vector3f>(model.mesh_vert + 3 * ptrdiff_t{i})
            .cast<double>());
  }
  return box;
}

/// In the shape's own frame.
AlignedBox3d ShapeBox(const mjModel& model, int geom) {
  const mjtNum* size = model.geom_size + 3 * ptrdiff_t{geom};
  switch (model.geom_type[geom]) {
    case mjGEOM_MESH:
      return MeshBox(model, model.geom_dataid[geom]);
    case mjGEOM_BOX: {
      const Vector3d half(size[0], size[1], size[2]);
      return {-half, half};
    }
    case mjGEOM_CYLINDER: {
      const Vector3d half(size[0], size[0], size[1]);
      return {-half, half};
    }
    default: {
      const Vector3d half = Vector3d::Constant(model.geom_rbound[geom]);
      return {-half, half};
    }
  }
}

OrientedBox BoxOf(const mjModel& model, int geom) {
  const AlignedBox3d box = ShapeBox(model, geom);
  const Isometry3d X_OG = PoseFromMujoco(model.geom_pos + 3 * ptrdiff_t{geom},
                                         model.geom_quat + 4 * ptrdiff_t{geom});
  return {X_OG * Eigen::Translation3d(box.center()), box.sizes() / 2};
}

}  // namespace

CollisionBounds::CollisionBounds(const mjModel& model, int body) {
  AlignedBox3d hull;
  const int begin = model.body_geomadr[body];
  for (int geom = begin; geom < begin + model.body_geomnum[body]; ++geom) {
    const int type = model.geom_contype[geom];
    const int affinity = model.geom_conaffinity[geom];
    if (type == 0 && affinity == 0) continue;
    const OrientedBox box = BoxOf(model, geom);
    shapes_.push_back({box, type, affinity});
    const Vector3d half = box.X_AB.linear().cwiseAbs() * box.half_extents;
    hull.extend(box.X_AB.translation() - half);
    hull.extend(box.X_AB.translation() + half);
  }
  if (shapes_.empty()) return;
  hull_ = {Isometry3d(Eigen::Translation3d(hull.center())), hull.sizes() / 2};
  reach_ = hull_.Reach();
}

bool CollisionBounds::MayCollideWithin(double distance, const Isometry3d& X_WO,
                                       const CollisionBounds& other,
                                       const Isometry3d& X_WOther) const {
  const double reach = reach_ + other.reach_ + distance;
  if ((X_WO.translation() - X_WOther.translation()).squaredNorm() >
      reach * reach) {
    return false;
  }
  const Isometry3d X_OOther = X_WO.inverse(Eigen::Isometry) * X_WOther;
  if (!vtb::MayBeWithin(hull_, other.hull_, X_OOther, distance)) return false;
  return std::ranges::any_of(shapes_, [&](const Shape& a) {
    return std::ranges::any_of(other.shapes_, [&](const Shape& b) {
      return ((a.type & b.affinity) != 0 || (b.type & a.affinity) != 0) &&
             vtb::MayBeWithin(a.box, b.box, X_OOther, distance);
    });
  });
}

bool CollisionBounds::MayBeWithin(double distance, const Isometry3d& X_WO,
                                  const OrientedBox& box) const {
  const double reach = reach_ + box.half_extents.norm() + distance;
  if ((X_WO.translation() - box.X_AB.translation()).squaredNorm() >
      reach * reach) {
    return false;
  }
  const Isometry3d X_OW = X_WO.inverse(Eigen::Isometry);
  return vtb::MayBeWithin(hull_, box, X_OW, distance) &&
         std::ranges::any_of(shapes_, [&](const Shape& shape) {
           return vtb::MayBeWithin(shape.box, box, X_OW, distance);
         });
}

}  // namespace cell::vtb
