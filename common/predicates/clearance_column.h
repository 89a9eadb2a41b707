#pragma once

#include <Eigen/Geometry>
#include <memory>

#include "common/geometry/part_shape.h"
#include "common/parts/part_table.h"

namespace cell {

/// A round column that must be empty for something to pass, along z of its
/// frame C.
class ClearanceColumn {
 public:
  /// From z = low to z = high, in m.
  ClearanceColumn(double radius, double low, double high);

  bool IsBlockedBy(const PartShape& part, const Eigen::Isometry3d& X_WO,
                   const Eigen::Isometry3d& X_WC) const;

 private:
  std::shared_ptr<const PartShape> column_;  // never changes: copies share it
};

}  // namespace cell
