#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "cell/truth_poses_t.hpp"

namespace cell {

/// The ground-truth poses of the testbed.
struct TruthPoses {
  int64_t utime = 0;  ///< [us since the start of the run]
  std::map<std::string, Eigen::Isometry3d> poses;  ///< X_WB of bodies
};

/// Nothing if there are too many bodies, duplicates, or a pose that is none.
std::optional<TruthPoses> TruthFromMessage(const truth_poses_t& message);

}  // namespace cell
