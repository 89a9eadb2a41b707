#pragma once

#include <optional>

#include "cell/arm_report_t.hpp"
#include "cell/execution_t.hpp"
#include "cell/operating_mode_t.hpp"
#include "cell/skill_request_t.hpp"
#include "cell/skill_result_t.hpp"
#include "common/relational/domain.h"
#include "services/planner/arms.h"
#include "services/planner/execution.h"

namespace cell::planner {

/// Nothing if arm or parts are not of the domain, parts come twice or out of
/// order, the id cannot be, or it is later than `now`.
std::optional<ArmStatus> FromMessage(const arm_report_t& message,
                                     const Domain& domain, int64_t now);

/// Nothing if the arm is not of the domain, the outcome is unknown, a number
/// cannot be, or it is later than `now`.
std::optional<ArmOutcome> FromMessage(const skill_result_t& message,
                                      const Domain& domain, int64_t now);

/// Whether arms may begin something; nothing for unknown or contradicting
/// codes.
std::optional<bool> MayActFromMessage(const operating_mode_t& message);

skill_request_t ToMessage(const ArmOrder& request, const Domain& domain);
execution_t ToMessage(const Execution& execution, const Domain& domain);

}  // namespace cell::planner
