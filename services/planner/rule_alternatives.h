#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/experiences/task_experience.h"
#include "common/relational/rule_set.h"

namespace cell::planner {

/// Rules of which one lacks some of its conditions.
struct RuleAlternative {
  std::shared_ptr<const RuleSet> rules;
  int action = 0;       ///< whose rule it is
  int num_dropped = 0;  ///< conditions
};

/// The rule alternatives for the robot in a state (section VI-B1), those with
/// the fewest dropped conditions first: conditions that fail there and name
/// none of the action's objects are dropped from a rule that was learned; what
/// they say of the action's own objects is kept. Left out is one that covers
/// `max_failures` experiences in which the action changed nothing.
std::vector<RuleAlternative> AlternativesIn(
    const RuleSet& rules, const State& state,
    std::span<const TaskExperience> experiences, int max_failures);

}  // namespace cell::planner
