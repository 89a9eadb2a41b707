#include "services/cell/evaluations/pose_noise.h"

#include "common/geometry/degree.h"

namespace cell::cli {

NoisyTracks::Params PoseNoise(double mm, uint64_t seed) {
  NoisyTracks::Params noise;
  noise.position_sd = mm * 1e-3;
  noise.rotation_sd = mm * 0.1 * kDegree;
  noise.seed = seed;
  return noise;
}

}  // namespace cell::cli
