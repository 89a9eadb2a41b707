#pragma once

#include "common/config/config.h"
#include "common/predicates/seat.h"

namespace cell {

/// The uncertainty of key frames' poses, from the noise of tracks that a
/// service is told of: `pose_noise_mm`, the standard deviation of each
/// coordinate, and `pose_noise_deg`, that of the rotation about each axis.
/// @throws ConfigError if one is missing, or not within 0 to 100 mm and 0 to
/// 90 degrees.
PoseUncertainty ReadPoseNoise(const Config& config);

}  // namespace cell
