#pragma once

#include "common/config/config.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "common/relational/domain.h"

namespace cell {

// The files of a task, held against each other: every name that one takes from
// another must be there. All throw ConfigError naming file:key.

/// Every grasp has a hand that can do it.
void CheckGrasps(const Config& parts_config, const PartTable& parts,
                 const CellLayout& layout);

/// Every action is possible for each of its agents, unless it has no rules as
/// none were learned of it; an arm that inserts is there, and so is the site,
/// which the part fits.
void CheckActions(const Config& domain_config, const Domain& domain,
                  const PartTable& parts, const CellLayout& layout);

/// Checks that the predicates which arms report name arms of the cell.
void CheckReports(const Config& domain_config, const Domain& domain,
                  const CellLayout& layout);

}  // namespace cell
