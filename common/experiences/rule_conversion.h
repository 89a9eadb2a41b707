#pragma once

#include <vector>

#include "common/experiences/rule_world.h"
#include "common/relational/rule.h"
#include "common/result/result.h"
#include "common/rules/rule.h"

namespace cell {

/// A learned rule in the words of the task's domain: it covers the same actions
/// in the same states, and each outcome gives the same state, for actions whose
/// objects are of the action's types. What the types already say is left out: a
/// literal that holds of no object of its argument's type is dropped if it is
/// negated. A reference gets the narrowest type that its literals give it. The
/// rule is for all agents of the action.
///
/// Refuses a rule that the domain has no words for, in plain words: one that
/// asks whether two objects are the same, one that compares numbers, one that
/// can never apply, and one with a literal that is defined for some objects of
/// its variable's type only.
Result<NdrRule> ToNdrRule(const rules::Rule& rule, const RuleWorld& world);

/// The actions of the world; those that rules were learned of have these
/// instead of their own. Refuses them like ToNdrRule().
Result<std::vector<Action>> WithLearnedRules(const rules::NdrRules& rules,
                                             const RuleWorld& world);

}  // namespace cell
