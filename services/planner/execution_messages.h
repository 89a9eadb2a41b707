#pragma once

#include <optional>

#include "cell/arm_report_t.hpp"
#include "cell/asked_skill_t.hpp"
#include "cell/execution_t.hpp"
#include "cell/operating_mode_t.hpp"
#include "cell/skill_result_t.hpp"
#include "common/relational/rule_set.h"
#include "services/planner/arm_states.h"
#include "services/planner/execution_status.h"
#include "services/planner/skill_request.h"

namespace cell::planner {

/// Nullopt if arm or parts are not of the vocabulary, parts come twice or out
/// of order, the id cannot be, or it is later than `now`.
std::optional<ArmState> FromMessage(const arm_report_t& message,
                                    const Vocabulary& vocabulary, int64_t now);

/// Nullopt if the arm is not of the vocabulary, the outcome is unknown, a
/// number cannot be, or it is later than `now`.
std::optional<SkillResult> FromMessage(const skill_result_t& message,
                                       const Vocabulary& vocabulary,
                                       int64_t now);

/// Whether arms may begin something; nullopt for unknown or contradicting
/// codes.
std::optional<bool> MayActFromMessage(const operating_mode_t& message);

asked_skill_t ToMessage(const SkillRequest& request,
                        const Vocabulary& vocabulary);
execution_t ToMessage(const ExecutionStatus& status, const RuleSet& rules);

}  // namespace cell::planner
