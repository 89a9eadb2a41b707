#pragma once

#include <string>
#include <vector>

#include "common/relational/rule.h"

namespace cell {

/// A rule of the action, a line each, as `cell rules show` prints one:
///
///   Action: Put(cup, shelf)
///   References: Z = tray: On(cup, tray)
///   Preconditions: Clear(shelf), not Full(shelf)
///   Effects:
///     0.90: On(cup, shelf), not On(cup, tray)
///       each P: not Clear(P) if On(P, shelf)
///     0.10: noise
///
/// @param binding  objects for the first variables, of which the names are then
///                 written; empty: the rule as it is
std::vector<std::string> RuleLines(const Action& action, const NdrRule& rule,
                                   const Binding& binding,
                                   const Vocabulary& vocabulary);

}  // namespace cell
