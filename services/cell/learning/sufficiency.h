#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/experiences/rule_world.h"
#include "common/relational/domain.h"
#include "common/relational/rule_set.h"
#include "common/rules/experience.h"

namespace cell::cli {

/// Whether rules that were learned from demonstrations are enough to reach a
/// goal.
struct Sufficiency {
  bool is_sufficient = false;
  /// Start states from which no plan reaches the goal.
  int num_without_plan = 0;
  /// Parts of the goal that no plan reaches from some start state, each by
  /// itself. Empty although not sufficient: only all of them together are out
  /// of reach.
  std::vector<Literal> uncovered;
};

/// @param rules   learned, of all actions that a person can do
/// @param starts  states that assemblies begin in
/// @throws std::invalid_argument if there is no start state
Sufficiency JudgeSufficiency(const std::shared_ptr<const RuleSet>& rules,
                             const Goal& goal, std::span<const State> starts);

/// The rules that are learned from experiences alone, which rely on nothing
/// that was never shown: an action that they do not show has none.
/// @throws std::invalid_argument if they have no words in the task's domain
std::shared_ptr<const RuleSet> LearnedRuleSet(
    std::span<const rules::Experience> experiences, std::span<const Goal> goals,
    const RuleWorld& world);

/// Does what the frozen rules plan, step by step, in a world that follows other
/// rules: the most likely outcome happens, and nothing where none applies.
/// True if the goal is reached.
bool ReachesGoal(const std::shared_ptr<const RuleSet>& rules, const Goal& goal,
                 const RuleSet& world, const State& start);

}  // namespace cell::cli
