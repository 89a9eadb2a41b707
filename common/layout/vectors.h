#pragma once

#include <Eigen/Geometry>
#include <string>

#include "common/config/config.h"

namespace cell {

Eigen::Vector2d Vector2(const Config& config, const std::string& key);
Eigen::Vector3d Vector3(const Config& config, const std::string& key);

/// A pose from `xyz` [m] and, optional, `rpy_deg`: about x, then y, then z of
/// the parent.
Eigen::Isometry3d PoseFromConfig(const Config& config);

}  // namespace cell
