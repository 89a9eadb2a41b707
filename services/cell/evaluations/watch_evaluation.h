#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// Watching a person assemble (sections VII and IX-B): valid orders, taking
/// back and unknown moves, planted mistakes.
std::unique_ptr<Evaluation> MakeWatchEvaluation();

}  // namespace cell::cli
