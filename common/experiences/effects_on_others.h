#pragma once

#include <span>

#include "common/experiences/rule_world.h"
#include "common/rules/experience.h"
#include "common/rules/rule.h"

namespace cell {

/// Adds to the outcomes of a rule what they change of objects that are no
/// arguments of the action: for each object for which some literals hold, an
/// atom becomes true, or false.
///
/// An outcome explains an experience if the rule covers it and the atoms of the
/// arguments change as the outcome says. These experiences are what
/// ConditionSearch finds the conditions in.
/// @param rule  with changes of its arguments only
/// @param experiences  with all their changes; those of other actions are
/// ignored
/// @param landmarks  symbols of literals that may name no object (only `_`)
void AddEffectsOnOthers(std::span<const rules::Experience> experiences,
                        std::span<const int> landmarks, const RuleWorld& world,
                        rules::Rule* rule);

}  // namespace cell
