#pragma once

#include "common/ppddl/problem.h"
#include "common/result/result.h"
#include "common/rexd/rexd_task.h"

namespace cell::rexd {

/// A PPDDL problem as a world to learn in. Each action becomes one rule that is
/// true, each type a predicate of one argument that is the condition of actions
/// (what their arguments may be). Hyphens in names become underscores. Costs
/// and rewards are left out.
///
/// The reason names what such rules have no words for: conditions other than
/// conjunctions of literals, conditional effects, more than three arguments.
Result<RexdTask> FromPpddl(const ppddl::Domain& domain,
                           const ppddl::Problem& problem);

}  // namespace cell::rexd
