#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// A part that was never shown is placed by a person: the cell recognises the
/// action by the role that the part plays, and the plan counts it.
std::unique_ptr<Evaluation> MakeSubstitutionEvaluation();

}  // namespace cell::cli
