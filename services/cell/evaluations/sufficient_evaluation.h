#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// `cell eval sufficient`: whether "the demonstrations suffice" is said exactly
/// when the model that was learned from them reaches the goal.
std::unique_ptr<Evaluation> MakeSufficientEvaluation();

}  // namespace cell::cli
