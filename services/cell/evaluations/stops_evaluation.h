#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// The arms assemble, and are stopped once in about every action: every stage
/// of every skill by a protective stop, the operator and the death of the arm's
/// service, in turn. All must be assembled in the end, and what was placed
/// before a stop must stay where it is until the arm is at work again.
std::unique_ptr<Evaluation> MakeStopsEvaluation();

}  // namespace cell::cli
