#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// Measures over the rows of a group, named "<group>: <what>".
///
/// Sums of two whole-numbered fields: successes of trials.
Measure ShareOf(const std::vector<nlohmann::json>& rows,
                const std::string& group, const std::string& what,
                const std::string& good, const std::string& all);
/// How many rows are good.
Measure RunsOf(const std::vector<nlohmann::json>& rows,
               const std::string& group, const std::string& what,
               const std::function<bool(const nlohmann::json&)>& is_good);

}  // namespace cell::cli
