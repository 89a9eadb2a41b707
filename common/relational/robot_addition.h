#pragma once

#include <functional>
#include <span>
#include <vector>

#include "common/relational/rule.h"

namespace cell {

/// What a rule needs besides if a robot acts, and what its success changes
/// besides.
struct RobotAddition {
  std::vector<Literal> context;
  std::vector<Literal> effects;
};

/// True if an effect of the rule contradicts one of the addition.
bool Contradicts(const NdrRule& rule, const RobotAddition& addition);

/// Gives the action's robot each of its rules that `is_meant`, once with each
/// addition, after all other rules. The other agents keep them as they are.
void AddForRobot(std::span<const RobotAddition> additions,
                 const std::function<bool(const NdrRule&)>& is_meant,
                 Action* action);

}  // namespace cell
