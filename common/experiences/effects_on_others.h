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
/// arguments change as the outcome says. Each object whose atom has the other
/// truth before such an experience is an example: positive if the atom has
/// changed after it. Conjunctions of literals are found by sequential covering
/// (FOIL, Quinlan 1990): the literal that tells positive from negative ones
/// best is added until no negative one is left, then those that are not needed
/// are removed; until all positive ones are covered. One that too few
/// experiences support is left out.
/// @param rule  with changes of its arguments only
/// @param experiences  with all their changes; those of other actions are
/// ignored
/// @param landmarks  symbols of literals that may name no object (only `_`)
void AddEffectsOnOthers(std::span<const rules::Experience> experiences,
                        std::span<const int> landmarks, const RuleWorld& world,
                        rules::Rule* rule);

}  // namespace cell
