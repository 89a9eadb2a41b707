#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/planning/excuse.h"
#include "common/planning/planner.h"
#include "common/planning/rollout.h"

namespace cell::cli {

/// What `cell plan` has found out about a problem.
struct PlanReport {
  std::string domain;
  std::string problem;
  planning::Plan plan;
  /// What would allow a plan, in plain words, one text for each excuse; and
  /// the changes, as literals.
  std::vector<std::string> excuses;
  std::vector<std::vector<std::string>> changes;
  std::vector<std::string> subgoals;  ///< of the first excuse
  std::optional<planning::Rollouts> rollouts;
  int64_t peak_bytes = 0;  ///< of the whole process
};

/// "found", "goal reached", "no plan", "undecided"
std::string ToText(planning::Plan::Status status);
std::string ToText(const PlanReport& report);
nlohmann::json ToJson(const PlanReport& report);

}  // namespace cell::cli
