#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// The cell assembles by itself while a person disturbs it (section IX-C).
/// Troubles that the cell can get over by itself must not keep it from its
/// goal; those that it cannot must end in a question that names just the part
/// that is missing.
std::unique_ptr<Evaluation> MakeDisturbedEvaluation();

}  // namespace cell::cli
