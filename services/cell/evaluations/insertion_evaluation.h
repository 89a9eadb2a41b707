#pragma once

#include <memory>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// Single insertions although the arm is wrong about where the site is (section
/// VIII-B), with the search and, for comparison, without.
std::unique_ptr<Evaluation> MakeInsertionEvaluation();

}  // namespace cell::cli
