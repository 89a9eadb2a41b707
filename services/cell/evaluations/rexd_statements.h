#pragma once

#include <string>
#include <vector>

#include "services/cell/evaluations/rexd_figures.h"

namespace cell::cli {

/// What the paper's text says about Fig. 17.
struct RexdStatement {
  std::string text;   ///< of the paper, in short
  std::string found;  ///< the values
  bool is_true = false;
};
/// @param floor  actions of the shortest way to the goal without a failure
std::vector<RexdStatement> CheckRexdStatements(
    const std::vector<RexdGroup>& groups, int num_episodes, double floor);

/// A line for each: "true  TEXT: FOUND".
std::string ToText(const std::vector<RexdStatement>& statements);

}  // namespace cell::cli
