#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "services/cell/evaluations/row_store.h"

namespace cell::cli {

/// Runs `run(i)` for each i whose key has no row yet, in processes of their
/// own, at most `num_processes` at a time; appends each result as a row and
/// shows progress. A run without a result is named on std::cerr.
/// @throws std::runtime_error that says how to go on if a signal stops it.
void DoMissingRuns(const std::vector<std::string>& keys, int num_processes,
                   const std::function<nlohmann::json(size_t)>& run,
                   RowStore* rows);

}  // namespace cell::cli
