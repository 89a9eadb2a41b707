#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// A cell that starts without actions, event chains and rules, learns them from
/// a person whom it asks, and does the task without asking from the third
/// episode on. Each run has a library of its own.
std::unique_ptr<Evaluation> MakeFromNothingEvaluation();

}  // namespace cell::cli
