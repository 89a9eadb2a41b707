#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// The arms pursue the goal of the task's demonstrators.yaml and are given
/// another goal of domain.yaml at a time of chance, by an operator's command.
std::unique_ptr<Evaluation> MakeGoalsEvaluation();

}  // namespace cell::cli
