#pragma once

#include <string>
#include <vector>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// A line per measure: rate, 95 % interval, goal and verdict.
std::string GoalTable(const std::vector<Measure>& measures);
/// True if every measure meets its goal.
bool AreMet(const std::vector<Measure>& measures);

}  // namespace cell::cli
