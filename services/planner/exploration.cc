#include "services/planner/exploration.h"

#include <algorithm>

#include "services/planner/outcome_prediction.h"
#include "services/planner/rule_alternatives.h"
#include "services/planner/unlearned.h"

namespace cell::planner {
namespace {

/// Rule alternatives that are planned with, at most.
constexpr size_t kMaxAlternatives = 10;

/// The rule of the robot that alone covers the state; nullptr if none does, or
/// several.
const NdrRule* CoveringRule(const RuleSet& rules, const GroundAction& action,
                            const State& state) {
  const Action& lifted = rules.ActionOf(action);
  const auto applicable = ApplicableRules(lifted, action.arguments, state,
                                          rules.vocabulary(), Agent::kRobot);
  if (applicable.size() != 1) return nullptr;
  return &lifted.rules[static_cast<size_t>(applicable[0].rule)];
}

/// For each literal of the subgoals that does not hold: it, and those of the
/// goal that hold.
std::vector<Goal> GoalsByLiteral(const Goal& goal, const Goal& subgoals,
                                 const State& state,
                                 const Vocabulary& vocabulary) {
  const auto holds = [&](const Literal& literal) {
    return MayHold(literal, {}, state, vocabulary);
  };
  Goal kept{goal.name, {}};
  std::ranges::copy_if(goal.literals, std::back_inserter(kept.literals), holds);
  std::vector<Goal> goals;
  for (const Literal& literal : subgoals.literals) {
    if (holds(literal)) continue;
    goals.push_back(kept);
    goals.back().literals.push_back(literal);
  }
  return goals;
}

/// The first step of a plan to one of the goals, if it can be done now.
std::optional<GroundAction> StepTowardsOne(
    const CurrentPlan& plan, const std::shared_ptr<const RuleSet>& rules,
    const std::vector<Goal>& goals, const State& state,
    const std::set<GroundAction>& blocked) {
  for (const Goal& goal : goals) {
    const Plan found =
        plan.MakeSolverFor(rules, goal, blocked)->FindWithoutReason(state);
    if (found.result == Plan::Result::kFound && !found.steps.empty() &&
        IsSurelyPossible(*rules, found.steps.front().action, state)) {
      return found.steps.front().action;
    }
  }
  return std::nullopt;
}

}  // namespace

bool IsNewToArms(const Action& action,
                 std::span<const TaskExperience> experiences) {
  const bool is_learned = std::ranges::any_of(
      action.rules,
      [](const NdrRule& rule) { return rule.num_experiences > 0; });
  return is_learned &&
         std::ranges::none_of(experiences, [&](const TaskExperience& e) {
           return e.agent == Agent::kRobot && e.action == action.name;
         });
}

std::optional<GroundAction> LeastTried(const RuleSet& rules, const State& state,
                                       const std::set<GroundAction>& blocked,
                                       int known_count) {
  std::optional<GroundAction> least;
  int least_count = known_count;
  for (const GroundAction& action : rules.GroundActions(Agent::kRobot)) {
    const NdrRule* rule = CoveringRule(rules, action, state);
    if (rule == nullptr || rule->num_experiences == 0 ||
        rule->num_experiences >= least_count || blocked.contains(action) ||
        MostLikelyOutcome(rules, action, state) == state.UnknownAsFalse()) {
      continue;
    }
    least_count = rule->num_experiences;
    least = action;
  }
  return least;
}

std::optional<GroundAction> StepWithoutPlan(
    const CurrentPlan& plan, const State& state,
    const std::set<GroundAction>& blocked, const Exploration& exploration) {
  const RuleSet& rules = plan.rules();
  const Goal subgoals = Subgoals(plan.problem(), state, plan.get().unlearned);
  const std::vector<Goal> goals =
      GoalsByLiteral(plan.problem().goal, subgoals, state, rules.vocabulary());
  if (goals.empty()) return std::nullopt;
  if (const auto step =
          StepTowardsOne(plan, plan.shared_rules(), goals, state, blocked)) {
    return step;
  }
  const auto alternatives = AlternativesIn(
      rules, state, *exploration.experiences, exploration.known_count);
  for (size_t i = 0; i < std::min(alternatives.size(), kMaxAlternatives); ++i) {
    if (const auto step = StepTowardsOne(plan, alternatives[i].rules, goals,
                                         state, blocked)) {
      return step;
    }
  }
  return std::nullopt;
}

}  // namespace cell::planner
