#include "common/predicates/pose_noise_config.h"

#include "common/geometry/degree.h"

namespace cell {

PoseUncertainty ReadPoseNoise(const Config& config) {
  return PoseUncertainty::OfKeyFrames(
      config.Number("pose_noise_mm", 0, 100) * 1e-3,
      config.Number("pose_noise_deg", 0, 90) * kDegree);
}

}  // namespace cell
