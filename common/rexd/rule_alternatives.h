#pragma once

#include <vector>

#include "common/rexd/guidance.h"
#include "common/rules/experience.h"

namespace cell::rexd {

/// Rules that the experiences allow just as well (Martinez et al., AIJ 2017):
/// in one rule, the literal of the precondition that keeps a blocked action
/// from being done is swapped for one that is true in the state. As the rule
/// covers the same experiences and has as many literals, the score S of
/// eq. (1) stays the same. Those with literals over the action's own objects
/// come first.
std::vector<rules::NdrRules> RuleAlternatives(
    const rules::NdrRules& rules, const rules::World& world,
    const rules::WorldState& state, const Guidance& guidance,
    const std::vector<rules::Experience>& experiences);

}  // namespace cell::rexd
