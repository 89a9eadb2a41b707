#include "services/cell/running/pose_noise_check.h"

#include <fmt/format.h>

#include <limits>
#include <string>

namespace cell::cli {
namespace {

constexpr double kMost = std::numeric_limits<double>::max();

void CheckEqual(const Deployment& deployment, const std::string& key,
                const std::string& service, const std::string& reference) {
  const Config config = deployment.ForService(service);
  const double told = config.Number(key, 0, kMost);
  const double wanted = deployment.ForService(reference).Number(key, 0, kMost);
  if (told == wanted) return;
  config[key].Fail(fmt::format(
      "{:g}, but {}.yaml says {:g}: the services see the same tracks, so that "
      "their noise is the same",
      told, reference, wanted));
}

}  // namespace

void CheckPoseNoise(const Deployment& deployment) {
  CheckEqual(deployment, "pose_noise_mm", "recognizer", "sec_builder");
  CheckEqual(deployment, "pose_noise_mm", "predicate_estimator", "sec_builder");
  CheckEqual(deployment, "pose_noise_deg", "predicate_estimator", "recognizer");
}

}  // namespace cell::cli
