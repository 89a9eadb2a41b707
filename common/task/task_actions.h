#pragma once

#include <set>
#include <string>

#include "common/relational/domain.h"

namespace cell {

/// Gives each action of the domain what follows from what is known of it: the
/// needs of its skill (WithSkillNeeds()), and unless the domain says it, what
/// it undoes: by the rules (DeriveUndone()), or by the event chains. An action
/// of a person that no event chain shows is recognised as the reverse of one
/// that takes the same arguments, if exactly one such action has an event
/// chain.
/// @param shown  names of the actions with an event chain
void CompleteActions(const std::set<std::string>& shown, Domain* domain);

}  // namespace cell
