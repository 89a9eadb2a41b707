#pragma once

#include "common/planning/ground_task.h"
#include "common/relational/domain.h"
#include "common/relational/rule_set.h"

namespace cell::planning {

/// The task of reaching a goal by rules from a state. Atom i of the task is
/// atom i of the vocabulary. What is unknown is taken as false; noise outcomes
/// change nothing. A rule holds only where its deictic references are unique
/// and no other rule of the action without references covers the state, too.
/// Actions are in the order of RuleSet::GroundActions() and named by
/// RuleSet::Show(); those that are left out can never apply.
GroundTask GroundRules(const RuleSet& rules, const Goal& goal, Agent agent,
                       const State& state);

}  // namespace cell::planning
