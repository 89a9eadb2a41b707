#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// The arms assemble each variant of the task, with the rules and event chains
/// of the task itself, and ask a person for what they cannot do (section
/// VI-B1: what was learned in one task helps in the next).
std::unique_ptr<Evaluation> MakeVariantsEvaluation();

}  // namespace cell::cli
