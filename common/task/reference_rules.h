#pragma once

#include "common/config/config.h"
#include "common/relational/domain.h"

namespace cell {

/// The domain with other rules than its own: what the task's author knows of
/// its actions, to hold what was learned against. Actions that the file does
/// not name keep theirs.
///
///   actions:
///     Insert:
///       arguments: {X: bolt, Y: hole}
///       rules: ...                       # as in domain.yaml
///
/// @throws ConfigError naming file:key, also for actions that the domain does
/// not have, or with other arguments
Domain WithReferenceRules(Domain domain, const Config& file);

}  // namespace cell
