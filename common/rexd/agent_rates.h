#pragma once

#include <vector>

#include "common/rules/experience.h"

namespace cell::rexd {

/// Rules with the outcome probabilities of one agent, and the experiences of
/// that agent that each rule covers.
struct AgentRules {
  rules::NdrRules rules;
  std::vector<int> counts;
};

/// What rules that were learned from all agents' experiences say of one of
/// them: the rules stay as they are, since what an action needs and does is
/// the same for all; how often it succeeds is not. A rule that covers none of
/// the agent's experiences keeps its probabilities.
AgentRules WithRatesOf(const std::vector<rules::Experience>& experiences,
                       rules::NdrRules rules, const rules::World& world);

}  // namespace cell::rexd
