#pragma once

#include <functional>

#include "common/experiences/rule_world.h"
#include "common/rules/experience.h"

namespace cell {

/// Calls visit(symbol, place) for every atom that is true in one of two states
/// and false in the other, ascending. Of a RuleWorld: there all atoms are
/// primitive.
void ForEachDifference(const rules::WorldState& a, const rules::WorldState& b,
                       const rules::World& world,
                       const std::function<void(int symbol, int place)>& visit);

/// The experience with the changes of its action's own objects only; all other
/// changes are undone.
rules::Experience OwnChanges(const rules::Experience& experience,
                             const RuleWorld& world);

/// The experience of an action of which another one is known that reverses it:
/// what was after that one is before this one.
rules::Experience Reversed(const rules::Experience& experience, int action);

}  // namespace cell
