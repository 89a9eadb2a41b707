#pragma once

#include "common/actions/action_model.h"
#include "common/actions/action_record.h"
#include "common/parts/part_table.h"
#include "common/relational/domain.h"

namespace cell {

/// Reads a record strictly, with the names of the domain. Errors begin with the
/// record's name, e.g. "Insert:rules[0].context[1]: ...". A removed record is
/// an action without agents, rules and event chain. @throws ConfigError for
/// names that the domain does not have, and for texts that are too long, have
/// anchors, or are not one YAML document.
ActionModel ReadActionModel(const ActionRecord& record, const Domain& domain,
                            const PartTable& parts);

/// The same without its event chain, for planning.
Action ReadAction(const ActionRecord& record, const Domain& domain);

}  // namespace cell
