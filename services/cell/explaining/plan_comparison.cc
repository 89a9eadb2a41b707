#include "services/cell/explaining/plan_comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "common/relational/rule_gap.h"
#include "services/cell/explaining/excuse_reasons.h"
#include "services/planner/outcome_prediction.h"

namespace cell::cli {
namespace {

using planner::DecisionBasis;
using planner::Judgement;
using planner::Plan;
using planner::PlanStep;
using planner::Problem;

std::string ChangesOf(const State& before, const State& after,
                      const Vocabulary& vocabulary) {
  std::vector<std::string> changes;
  for (int atom = 0; atom < after.num_atoms(); ++atom) {
    const Truth truth = after.Get(atom);
    if (truth == before.Get(atom)) continue;
    changes.push_back((truth == Truth::kTrue      ? ""
                       : truth == Truth::kUnknown ? "unknown "
                                                  : "not ") +
                      vocabulary.AtomName(atom));
  }
  return changes.empty() ? "nothing"
                         : fmt::format("{}", fmt::join(changes, ", "));
}

/// The states of the steps' most likely course; it may end early.
std::vector<State> CourseOf(const Problem& problem, const State& state,
                            const std::vector<PlanStep>& steps) {
  std::vector<State> states = {state.UnknownAsFalse()};
  for (const PlanStep& step : steps) {
    const auto after = planner::MostLikelyOutcome(*problem.rules, step.action,
                                                  states.back(), problem.agent);
    if (!after) break;
    states.push_back(*after);
  }
  return states;
}

/// The literals that hold after but not before.
Reasons MadeTrue(const std::vector<Literal>& literals, const Binding& binding,
                 const State& before, const State& after,
                 const Vocabulary& vocabulary) {
  std::vector<std::string> made;
  for (const Literal& literal : literals) {
    if (MustHold(literal, binding, after, vocabulary) &&
        !MustHold(literal, binding, before, vocabulary)) {
      made.push_back(Show(literal, binding, vocabulary));
    }
  }
  return made;
}

/// What the step of the course makes true that the covering rule of a later one
/// asks for, or else the goal.
std::string PurposeOf(const Problem& problem, const std::vector<State>& course,
                      const std::vector<PlanStep>& steps, size_t step) {
  if (step + 1 >= course.size()) return "";
  const RuleSet& rules = *problem.rules;
  const State& before = course[step];
  const State& after = course[step + 1];
  for (size_t later = step + 1; later < course.size() && later < steps.size();
       ++later) {
    const GroundAction& action = steps[later].action;
    for (const RuleGap& gap :
         GapsOf(rules, action, course[later], problem.agent)) {
      if (!gap.is_covered()) continue;
      const NdrRule& rule =
          rules.ActionOf(action).rules.at(static_cast<size_t>(gap.rule));
      const auto made = MadeTrue(rule.context, gap.binding, before, after,
                                 rules.vocabulary());
      if (made.empty()) continue;
      return fmt::format("{} needs {}", rules.Show(action),
                         fmt::join(made, ", "));
    }
  }
  const auto made =
      MadeTrue(problem.goal.literals, {}, before, after, rules.vocabulary());
  return made.empty() ? ""
                      : fmt::format("the goal needs {}", fmt::join(made, ", "));
}

/// Places of the steps in `after` that `before` does not have as often.
std::vector<size_t> AddedSteps(const std::vector<PlanStep>& before,
                               const std::vector<PlanStep>& after) {
  std::vector<GroundAction> left;
  for (const PlanStep& step : before) left.push_back(step.action);
  std::vector<size_t> added;
  for (size_t i = 0; i < after.size(); ++i) {
    const auto same = std::ranges::find(left, after[i].action);
    if (same == left.end()) {
      added.push_back(i);
    } else {
      left.erase(same);
    }
  }
  return added;
}

void AddLonger(const Problem& problem, const State& after, const Plan& before,
               const Plan& plan, Reasons* lines) {
  const auto course = CourseOf(problem, after, plan.steps);
  for (const size_t i : AddedSteps(before.steps, plan.steps)) {
    const std::string why = PurposeOf(problem, course, plan.steps, i);
    lines->push_back(
        "now necessary besides: " + problem.rules->Show(plan.steps[i].action) +
        (why.empty() ? "" : ", since " + why));
  }
}

}  // namespace

Reasons ComparePlans(const DecisionBasis& basis, const Judgement& judgement) {
  const Problem& problem = basis.problem;
  const auto solver = basis.make_solver(problem);
  Reasons lines;
  std::optional<Plan> before;
  if (judgement.before) {
    lines.push_back("it has changed: " +
                    ChangesOf(*judgement.before, judgement.after,
                              problem.rules->vocabulary()));
    before = solver->Find(*judgement.before);
    lines.push_back("without it: " + PlanText(*before, *problem.rules));
  } else if (judgement.expected_actions_before) {
    lines.push_back(fmt::format("before it: {:.2f} actions expected",
                                *judgement.expected_actions_before));
  }
  const Plan after = solver->Find(judgement.after);
  if (HasNoPlan(after)) {
    Append(NoPlanReasons(basis, judgement.after, after), &lines);
    return lines;
  }
  lines.push_back("after it: " + PlanText(after, *problem.rules));
  if (before) AddLonger(problem, judgement.after, *before, after, &lines);
  return lines;
}

}  // namespace cell::cli
