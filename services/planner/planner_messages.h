#pragma once

#include <optional>

#include "cell/action_t.hpp"
#include "cell/alert_t.hpp"
#include "cell/plan_t.hpp"
#include "cell/predicates_t.hpp"
#include "common/relational/domain.h"
#include "services/planner/monitor.h"

namespace cell::planner {

/// Nothing if an atom is not of the domain, comes twice, or has an unknown
/// code. Atoms that are not listed are unknown.
std::optional<SensedState> FromMessage(const predicates_t& message,
                                       const Domain& domain);

/// Nothing if names, arguments, codes or key frames cannot be.
std::optional<DoneAction> FromMessage(const action_t& message,
                                      const Domain& domain);

plan_t ToMessage(const Monitor::PlanOfState& plan, const Domain& domain);
alert_t ToMessage(const Alert& alert);

}  // namespace cell::planner
