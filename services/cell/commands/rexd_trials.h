#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

#include "services/cell/commands/eval_rexd_options.h"
#include "services/cell/evaluations/rexd_figures.h"
#include "services/cell/evaluations/row_identity.h"
#include "services/cell/evaluations/row_shape.h"

namespace cell::cli {

/// The rows of all trials, and how many are missing.
struct RexdTrialRows {
  std::vector<RexdGroup> groups;  ///< by success, of those that have rows
  size_t num_rows = 0;
  size_t num_trials = 0;
  std::filesystem::path file;

  bool is_complete() const { return num_rows == num_trials; }
};

/// Runs the trials that have no row yet in the file of rows.
/// @param shape  of what `run` returns
/// @throws as RowStore and DoMissingRuns() do
RexdTrialRows RunTrials(
    const EvalRexdOptions& options, const RowIdentity& identity,
    const RowShape& shape,
    const std::function<nlohmann::json(const RexdTrial&)>& run);

/// "rows in FILE (3 of 4 runs)"
std::string ToText(const RexdTrialRows& rows);

}  // namespace cell::cli
