#pragma once

#include <vector>

#include "common/layout/cell_layout.h"
#include "services/vtb/hands.h"
#include "services/vtb/oriented_box.h"

namespace cell::vtb {

/// Where a box of a hand is in W before a call of World::Run(), and how far it
/// goes within it.
struct HandSweep {
  OrientedBox box;
  double travel = 0;  ///< [m] no point of it moves further
};

/// Of all boxes of all hands.
std::vector<HandSweep> SweepsOf(const CellLayout& layout, const Hands& hands);

}  // namespace cell::vtb
