#pragma once

#include "common/config/deployment.h"

namespace cell::cli {

/// Checks that sec_builder, recognizer and predicate_estimator are told of the
/// same noise of poses: the tracks that they see are the same.
/// @throws ConfigError "file:key: message (line N)".
void CheckPoseNoise(const Deployment& deployment);

}  // namespace cell::cli
