#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "common/arms/arm_scene.h"
#include "common/arms/reach.h"
#include "services/vtb/placement_sampler.h"

namespace cell::vtb {

/// Whether the cell's arms can take what a script lays down, with a little more
/// room to all sides than they ask for: only then can the run be solved.
class WithinReach {
 public:
  /// Both must outlive this object.
  WithinReach(const PartTable& table, const CellLayout& layout);

  /// True if some arm can take `part` where it lies among the others, with all
  /// arms at home.
  bool CanTake(const std::string& part,
               const std::vector<PlacementSampler::Placed>& scene) const;
  /// @param but  which parts need not be taken
  bool CanTakeAll(const std::vector<PlacementSampler::Placed>& scene,
                  const PlacementSampler::Starts& but = {}) const;

 private:
  bool CanTakeIn(const ArmScene& scene, const std::string& part) const;

  CellLayout layout_;  ///< with narrower workspaces
  ArmScene empty_;
  ReachParams params_;
};

}  // namespace cell::vtb
