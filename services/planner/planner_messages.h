#pragma once

#include <optional>
#include <set>
#include <string>

#include "cell/alert_t.hpp"
#include "cell/plan_t.hpp"
#include "cell/predicates_t.hpp"
#include "cell/recognised_action_t.hpp"
#include "common/relational/rule_set.h"
#include "services/planner/decision_maker.h"
#include "services/planner/demonstrations.h"

namespace cell::planner {

/// Nullopt if an atom is not of the vocabulary, comes twice, or has an unknown
/// code. Atoms that are not listed are unknown.
std::optional<SensedState> FromMessage(const predicates_t& message,
                                       const Vocabulary& vocabulary);

/// Nullopt if names, arguments, codes or key frames cannot be.
std::optional<DoneAction> FromMessage(const recognised_action_t& message,
                                      const RuleSet& rules);

/// What a person's hand has shown, if it is recognised, or has opened or joined
/// a record of the library; nullopt otherwise.
std::optional<ShownAction> ShownActionFrom(
    const recognised_action_t& message,
    const std::set<std::string>& hands_of_people, const RuleSet& rules);

plan_t ToMessage(const PlanOfState& plan, const RuleSet& rules);
alert_t ToMessage(const Alert& alert);

}  // namespace cell::planner
