#include "services/cell/learning/sufficiency.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "common/experiences/rule_conversion.h"
#include "common/experiences/rule_lessons.h"
#include "services/planner/plan_search.h"

namespace cell::cli {
namespace {

using planner::Plan;
using planner::PlanSearch;

bool HasPlan(const Plan& plan) {
  return plan.result == Plan::Result::kFound ||
         plan.result == Plan::Result::kGoalReached;
}

/// The state after the most likely outcome of the only rule that applies;
/// nullopt if none or several do.
std::optional<State> MostLikelyAfter(const GroundAction& action,
                                     const State& state, const RuleSet& world) {
  const Action& lifted = world.ActionOf(action);
  const auto applicable = ApplicableRules(lifted, action.arguments, state,
                                          world.vocabulary(), Agent::kPerson);
  if (applicable.size() != 1) return std::nullopt;
  const NdrRule& rule =
      lifted.rules[static_cast<size_t>(applicable.front().rule)];
  const auto likely =
      std::ranges::max_element(rule.outcomes, {}, &Outcome::probability);
  if (likely == rule.outcomes.end()) return std::nullopt;
  return Apply(*likely, applicable.front().binding, state, world.vocabulary());
}

}  // namespace

Sufficiency JudgeSufficiency(const std::shared_ptr<const RuleSet>& rules,
                             const Goal& goal, std::span<const State> starts) {
  if (starts.empty()) throw std::invalid_argument("no start state");
  Sufficiency judged;
  PlanSearch search({rules, goal, Agent::kPerson}, {});
  std::vector<State> without;
  for (const State& start : starts) {
    if (!HasPlan(search.Find(start))) without.push_back(start);
  }
  judged.num_without_plan = static_cast<int>(without.size());
  judged.is_sufficient = without.empty();
  for (const Literal& literal : goal.literals) {
    if (without.empty()) break;
    PlanSearch alone({rules, {goal.name, {literal}}, Agent::kPerson}, {});
    const bool is_covered = std::ranges::all_of(
        without, [&](const State& s) { return HasPlan(alone.Find(s)); });
    if (!is_covered) judged.uncovered.push_back(literal);
  }
  return judged;
}

std::shared_ptr<const RuleSet> LearnedRuleSet(
    std::span<const rules::Experience> experiences, std::span<const Goal> goals,
    const RuleWorld& world) {
  std::vector<Action> bare = world.actions();
  for (Action& action : bare) action.rules.clear();
  const auto vocabulary =
      std::make_shared<const Vocabulary>(world.vocabulary());
  const RuleWorld unknown(vocabulary, bare);
  const auto learned = WithLearnedRules(
      LearnRules(experiences, GoalPredicates(goals), world, 1), unknown);
  if (!learned) throw std::invalid_argument(learned.reason());
  return std::make_shared<const RuleSet>("what was shown", 1, vocabulary,
                                         *learned);
}

bool ReachesGoal(const std::shared_ptr<const RuleSet>& rules, const Goal& goal,
                 const RuleSet& world, const State& start) {
  PlanSearch search({rules, goal, Agent::kPerson}, {});
  std::vector<State> visited;
  State state = start;
  // A frozen plan does the same in the same state again.
  while (std::ranges::count(visited, state) == 0) {
    visited.push_back(state);
    const Plan plan = search.Find(state);
    if (plan.result == Plan::Result::kGoalReached) return true;
    if (plan.result != Plan::Result::kFound || plan.steps.empty()) return false;
    const auto after = MostLikelyAfter(plan.steps.front().action, state, world);
    if (after) state = *after;
  }
  return false;
}

}  // namespace cell::cli
