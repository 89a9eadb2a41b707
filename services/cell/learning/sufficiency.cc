#include "services/cell/learning/sufficiency.h"

#include <algorithm>
#include <stdexcept>

#include "common/experiences/rule_conversion.h"
#include "common/experiences/rule_lessons.h"
#include "services/planner/outcome_prediction.h"
#include "services/planner/plan_search.h"

namespace cell::cli {
namespace {

using planner::Plan;
using planner::PlanSearch;

}  // namespace

Sufficiency JudgeSufficiency(const std::shared_ptr<const RuleSet>& rules,
                             const Goal& goal, std::span<const State> starts) {
  if (starts.empty()) throw std::invalid_argument("no start state");
  Sufficiency judged;
  PlanSearch search({rules, goal, Agent::kPerson}, {});
  std::vector<State> without;
  for (const State& start : starts) {
    if (!search.Find(start).leads_to_goal()) without.push_back(start);
  }
  judged.num_without_plan = static_cast<int>(without.size());
  judged.is_sufficient = without.empty();
  for (const Literal& literal : goal.literals) {
    if (without.empty()) break;
    PlanSearch alone({rules, {goal.name, {literal}}, Agent::kPerson}, {});
    const bool is_covered = std::ranges::all_of(
        without, [&](const State& s) { return alone.Find(s).leads_to_goal(); });
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
    const auto after = planner::MostLikelyOutcome(
        world, plan.steps.front().action, state, Agent::kPerson);
    if (after) state = *after;
  }
  return false;
}

}  // namespace cell::cli
