#pragma once

#include <vector>

#include "common/planning/ground_task.h"

namespace cell::planning {

/// Conjunctions of which one has to hold: none is false, an empty one is true.
using Alternatives = std::vector<Conjunction>;

Alternatives True();
Alternatives False();

/// Holds if both do. At most as many alternatives as the product of theirs;
/// those that contradict themselves are left out.
Alternatives Both(const Alternatives& a, const Alternatives& b);
/// Holds if one does. Two single literals or clauses make one clause.
Alternatives Either(Alternatives a, const Alternatives& b);
/// Holds if none of the alternatives does.
Alternatives Neither(const Alternatives& alternatives);

}  // namespace cell::planning
