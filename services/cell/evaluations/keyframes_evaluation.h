#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// Key frames of demonstrations (section V-B) against contact truth, where the
/// poses of parts and hands are noisy. A run is simulated once, and disturbed
/// offline at each level of noise.
std::unique_ptr<Evaluation> MakeKeyframesEvaluation();

}  // namespace cell::cli
