#pragma once

#include "common/relational/domain.h"

namespace cell {

/// Gives each action of the domain, once it has its rules, what follows from
/// them and from its skill: WithSkillNeeds(), and DeriveUndone() unless the
/// domain says what it undoes.
void CompleteActions(Domain* domain);

}  // namespace cell
