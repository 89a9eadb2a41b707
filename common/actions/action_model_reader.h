#pragma once

#include "common/actions/action_model.h"
#include "common/actions/action_record.h"
#include "common/parts/part_table.h"
#include "common/relational/domain.h"

namespace cell {

/// Reads a record strictly, in the words of the domain. Errors begin with the
/// record's name, e.g. "Insert:rules[0].context[1]: ...".
/// @throws ConfigError for what makes no sense there, for texts that are not
/// one YAML document each, without anchors, and for too long ones. One that is
/// removed is an action without agents, rules and event chain.
ActionModel ReadActionModel(const ActionRecord& record, const Domain& domain,
                            const PartTable& parts);

/// The same without its event chain, for planning.
Action ReadAction(const ActionRecord& record, const Domain& domain);

}  // namespace cell
