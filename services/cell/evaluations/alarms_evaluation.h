#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// Watching persons who assemble correctly, in many orders, who deviate from
/// what leads to the goal, and who end in a dead end (section VII-C): what is
/// said of each action, and how soon, by the ground truth.
std::unique_ptr<Evaluation> MakeAlarmsEvaluation();

}  // namespace cell::cli
