#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// `cell eval one_showing`: how many steps of further assemblies, without
/// noise, a library recognises that was learned from a single showing of each
/// action (of the task's recordings, the first that has the action's name).
std::unique_ptr<Evaluation> MakeOneShowingEvaluation();

}  // namespace cell::cli
