#pragma once

#include <optional>
#include <string>

#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"

namespace cell {

/// Why a cell of these arms cannot be: "key: reason" with the key of cell.yaml,
/// e.g. "arms.left.home: arm_left.link_3 would hit arm_right.link_5".
/// Nothing if it can: bases upright and above the table; tools within the
/// payload; homes within joint limits, clear of each other, of the table, the
/// pedestal and the fixed parts; homes and exchanges within the workspace.
std::optional<std::string> WhyCellImpossible(const PartTable& parts,
                                             const CellLayout& layout);

/// @throws ConfigError "file:key: reason" for a cell that cannot be.
void CheckCell(const Config& cell_config, const PartTable& parts,
               const CellLayout& layout);

}  // namespace cell
