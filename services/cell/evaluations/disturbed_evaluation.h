#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// The cell assembles by itself while a person disturbs it (section IX-C). It
/// must reach its goal in spite of disturbances that it can recover from; all
/// others must end in a question that names exactly the part that is missing.
std::unique_ptr<Evaluation> MakeDisturbedEvaluation();

}  // namespace cell::cli
