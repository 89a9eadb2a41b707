#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// The cell assembles by itself (sections VIII and IX): parts seated, screws
/// tightened, parts that come loose, and how the arms behave.
std::unique_ptr<Evaluation> MakeAssemblyEvaluation();

}  // namespace cell::cli
