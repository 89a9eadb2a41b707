#pragma once

#include <vector>

#include "common/planning/ground_task.h"
#include "common/result/result.h"
#include "common/rexd/rexd_task.h"

namespace cell::rexd {

/// Rules as a task without variables, in the terms of planning::FindExcuses().
struct RuleTask {
  planning::GroundTask task;
  std::vector<rules::Literal> atoms;     ///< of the task, as true literals
  std::vector<rules::GroundAct> act_of;  ///< of each action of the task
};

/// What reaches the goal by rules from a state. A rule applies where its
/// deictic references are unique and no other rule covers the action; noise
/// changes nothing. Derived predicates are replaced by their definitions.
///
/// The reason names a function, closure, count or sum that a rule asks for, or
/// the action whose conditions are too large.
/// @param acts  the actions that may be used
Result<RuleTask> GroundRuleTask(const rules::NdrRules& rules,
                                const RexdTask& task,
                                const rules::WorldState& state,
                                const std::vector<rules::GroundAct>& acts);

}  // namespace cell::rexd
