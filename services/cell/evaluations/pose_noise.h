#pragma once

#include <cstdint>

#include "common/recordings/noisy_tracks.h"

namespace cell::cli {

/// Pose noise of `mm` standard deviation of each coordinate, correlated in
/// time; rotations are disturbed by 0.1 degrees for each mm.
NoisyTracks::Params PoseNoise(double mm, uint64_t seed);

}  // namespace cell::cli
