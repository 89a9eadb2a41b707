#include "services/vtb/part_bodies.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "services/vtb/mujoco_pose.h"

namespace cell::vtb {

using Eigen::Isometry3d;
using Eigen::Vector3d;

PartBodies::PartBodies(const PartTable& table, const CellLayout& layout,
                       const mjModel& model)
    : table_(table), X_WP_(layout.pedestal.X_WP) {
  for (const Part& part : table_.parts()) {
    Body& body = bodies_.emplace_back();
    body.id = mj_name2id(&model, mjOBJ_BODY, part.name.c_str());
    const int joint = model.body_jntadr[body.id];
    if (joint >= 0) {
      body.qpos = model.jnt_qposadr[joint];
      body.dof = model.jnt_dofadr[joint];
      body.num_positions = part.joint ? 1 : 7;
      body.num_dofs = part.joint ? 1 : 6;
    }
    body.centre = MomentsOf(part.pieces).centre;
  }
}

size_t PartBodies::IndexOf(const std::string& part) const {
  const auto& parts = table_.parts();
  const auto it = std::ranges::find(parts, part, &Part::name);
  if (it == parts.end()) {
    throw std::invalid_argument("no part is named '" + part + "'");
  }
  return static_cast<size_t>(it - parts.begin());
}

Isometry3d PartBodies::PoseOf(size_t part, const mjData& data) const {
  const int address = bodies_[part].qpos;
  if (address < 0) return X_WP_;
  if (const auto& joint = table_.parts()[part].joint) {
    return X_WP_ * joint->X_HO_zero * joint->Displacement(data.qpos[address]);
  }
  return PoseFromMujoco(data.qpos + address, data.qpos + address + 3);
}

double PartBodies::SpeedOf(size_t part, const mjData& data) const {
  const int dof = bodies_[part].dof;
  if (dof < 0) return 0;
  const auto& joint = table_.parts()[part].joint;
  if (!joint) return Eigen::Map<const Vector3d>(data.qvel + dof).norm();
  const Vector3d p_OG = table_.parts()[part].grasps.front().X_OG.translation();
  return std::abs(data.qvel[dof]) * joint->LeverAt(p_OG);
}

}  // namespace cell::vtb
