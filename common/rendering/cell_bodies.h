#pragma once

#include <vector>

#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "common/rendering/body.h"

namespace cell {

/// All that is seen in a cell: the parts, the boxes of the hands
/// ("<hand>.<box>", each with its middle in its frame), the bodies of the arms
/// (BodyPartsOf), and, where these are fixed, "table" and "pedestal".
std::vector<RenderBody> BodiesOf(const PartTable& parts,
                                 const CellLayout& layout);

}  // namespace cell
