#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"

namespace cell::vtb {

/// The parts of the table as bodies of the physics.
class PartBodies {
 public:
  struct Body {
    int id = 0;
    int qpos = -1, dof = -1;              ///< addresses of its joint; -1: fixed
    int num_positions = 0, num_dofs = 0;  ///< there
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();  ///< of mass, in O
  };

  /// The table must outlive this object.
  PartBodies(const PartTable& table, const CellLayout& layout,
             const mjModel& model);
  PartBodies(const PartBodies&) = delete;
  PartBodies& operator=(const PartBodies&) = delete;

  const Body& operator[](size_t part) const { return bodies_[part]; }
  /// @throws std::invalid_argument if no part has the name.
  size_t IndexOf(const std::string& part) const;

  Eigen::Isometry3d PoseOf(size_t part, const mjData& data) const;
  /// [m/s] Of its origin; of an articulated part, of its handle.
  double SpeedOf(size_t part, const mjData& data) const;

 private:
  const PartTable& table_;
  Eigen::Isometry3d X_WP_;  // of the fixed parts
  std::vector<Body> bodies_;
};

}  // namespace cell::vtb
