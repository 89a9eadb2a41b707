#pragma once

#include <vector>

#include "common/planning/ground_task.h"
#include "common/relational/domain.h"
#include "common/relational/rule_set.h"

namespace cell::planning {

/// The task of a rule set. Atom i of the task is atom i of the vocabulary.
struct RuleTask {
  GroundTask task;
  /// Of each action of the task. Several may do the same ground action: one for
  /// each rule and each way to bind its references.
  std::vector<cell::GroundAction> action_of;
};

/// What reaches a goal by rules from a state. What is unknown is taken as
/// false; noise outcomes change nothing. A rule holds where its deictic
/// references are unique and no other rule of the action covers the state, too.
/// Actions are in the order of RuleSet::GroundActions(), named by
/// RuleSet::Show().
RuleTask GroundRules(const RuleSet& rules, const Goal& goal, Agent agent,
                     const State& state);

/// The truths of a state's atoms, as GroundModel::Pack() takes them; unknown
/// ones are false.
std::vector<bool> AtomsOf(const State& state);

}  // namespace cell::planning
