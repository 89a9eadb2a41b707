#include "services/cell/explaining/excuse_reasons.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "services/cell/explaining/alternative_reasons.h"
#include "services/cell/explaining/rule_reasons.h"

namespace cell::cli {
namespace {

using planner::DecisionBasis;
using planner::Plan;
using planner::Problem;
using planner::RequiredChange;

std::string Needed(const RequiredChange& change, const Vocabulary& vocabulary) {
  return (change.truth == Truth::kTrue ? "" : "not ") +
         vocabulary.AtomName(change.atom);
}

/// The plan once all that is needed is so.
Plan PlanIf(const DecisionBasis& basis, State state, const Plan& no_plan) {
  for (const RequiredChange& change : no_plan.needed) {
    state.Set(change.atom, change.truth);
  }
  return basis.make_solver(basis.problem)->Find(state);
}

void AddNeeded(const DecisionBasis& basis, const State& state,
               const RequiredChange& change, Reasons* lines) {
  const Vocabulary& vocabulary = basis.problem.rules->vocabulary();
  lines->push_back("needed: " + Needed(change, vocabulary));
  if (!change.needed_by) return;
  Append(RuleThatNeeds(basis.problem, *change.needed_by, state, change), lines);
}

/// As if nothing had failed.
void AddWithoutFailures(const DecisionBasis& basis, Reasons* lines) {
  if (basis.problem.blocked.empty()) return;
  Problem unblocked = basis.problem;
  unblocked.blocked.clear();
  const Plan plan = basis.make_solver(unblocked)->Find(basis.state);
  if (!plan.leads_to_goal()) return;
  lines->push_back("without these failures the plan would be: " +
                   PlanText(plan, *basis.problem.rules));
}

/// What sensing leaves open of the plan's first step.
void AddUnknown(const DecisionBasis& basis, Reasons* lines) {
  const Vocabulary& vocabulary = basis.problem.rules->vocabulary();
  std::vector<std::string> names;
  for (const int atom : basis.state.UnknownAtoms()) {
    names.push_back(vocabulary.AtomName(atom));
  }
  if (names.empty()) return;
  lines->push_back(fmt::format("unknown are: {}", fmt::join(names, ", ")));
}

Reasons NotLearnedReasons(const DecisionBasis& basis, const Plan& plan) {
  Reasons lines = {fmt::format("no plan leads to the goal '{}': {}",
                               basis.problem.goal.name, plan.reason)};
  for (const Literal& literal : plan.unlearned) {
    lines.push_back(fmt::format(
        "no rule (version {}) has an outcome with {}: nobody has shown it",
        basis.problem.rules->version(),
        Show(literal, {}, basis.problem.rules->vocabulary())));
  }
  return lines;
}

void AddFirstStep(const DecisionBasis& basis, bool is_verbose, Reasons* lines) {
  if (basis.plan.steps.empty()) return;
  const GroundAction& first = basis.plan.steps[0].action;
  lines->push_back("the best plan begins with " +
                   basis.problem.rules->Show(first));
  Append(CoveringRules(basis.problem, first, basis.state), lines);
  Append(AlternativeReasons(basis, first, is_verbose), lines);
}

}  // namespace

std::string PlanText(const Plan& plan, const RuleSet& rules) {
  if (plan.result == Plan::Result::kGoalReached) return "the goal is reached";
  if (plan.result != Plan::Result::kFound) return "no plan: " + plan.reason;
  std::vector<std::string> steps;
  for (const planner::PlanStep& step : plan.steps) {
    steps.push_back(rules.Show(step.action));
  }
  return fmt::format("{:.2f} actions expected: {}", plan.expected_actions,
                     fmt::join(steps, ", "));
}

bool HasNoPlan(const Plan& plan) {
  return plan.result == Plan::Result::kNoPlan ||
         plan.result == Plan::Result::kNotLearned;
}

Reasons NoPlanReasons(const DecisionBasis& basis, const State& state,
                      const Plan& no_plan) {
  if (no_plan.result == Plan::Result::kNotLearned) {
    return NotLearnedReasons(basis, no_plan);
  }
  Reasons lines = {fmt::format("no plan leads to the goal '{}': {}",
                               basis.problem.goal.name, no_plan.reason)};
  for (const RequiredChange& change : no_plan.needed) {
    AddNeeded(basis, state, change, &lines);
  }
  if (no_plan.needed.empty()) {
    lines.emplace_back("no change that a person could make allows a plan");
    return lines;
  }
  lines.push_back("if that were so: " + PlanText(PlanIf(basis, state, no_plan),
                                                 *basis.problem.rules));
  return lines;
}

Reasons QuestionReasons(const DecisionBasis& basis,
                        const planner::ExecutionStatus& question,
                        bool is_verbose) {
  Reasons lines = FailureReasons(basis);
  if (question.step) {
    AddFirstStep(basis, is_verbose, &lines);
    lines.emplace_back("this step is left to a person (help_steps)");
  } else if (HasNoPlan(basis.plan)) {
    AddWithoutFailures(basis, &lines);
    Append(NoPlanReasons(basis, basis.state, basis.plan), &lines);
  } else {
    AddFirstStep(basis, is_verbose, &lines);
    AddUnknown(basis, &lines);
    if (!basis.plan.reason.empty()) lines.push_back(basis.plan.reason);
  }
  return lines;
}

}  // namespace cell::cli
