#include "services/cell/explaining/decision_explainer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <utility>

#include "services/cell/explaining/alternative_reasons.h"
#include "services/cell/explaining/excuse_reasons.h"
#include "services/cell/explaining/plan_comparison.h"
#include "services/cell/explaining/rule_reasons.h"

namespace cell::cli {
namespace {

using planner::Alert;
using planner::DecisionBasis;
using planner::Decisions;
using planner::Plan;
using planner::SkillRequest;

bool IsQuestion(const Decisions& decisions) {
  return decisions.execution &&
         decisions.execution->state == planner::ExecutionStatus::State::kStuck;
}

/// The robot's questions are told by the status, and by an alert again.
bool IsExplained(const Alert& alert) {
  return alert.cause != Alert::Cause::kStuck &&
         alert.cause != Alert::Cause::kBadInput;
}

std::string GoalText(const DecisionBasis& basis) {
  return fmt::format("the goal '{}'", basis.problem.goal.name);
}

/// Place of the action among the plan's steps.
std::optional<size_t> PlaceOf(const GroundAction& action, const Plan& plan) {
  const auto it =
      std::ranges::find(plan.steps, action, &planner::PlanStep::action);
  if (it == plan.steps.end()) return std::nullopt;
  return static_cast<size_t>(it - plan.steps.begin());
}

Reasons WhyBestAction(const DecisionBasis& basis, const GroundAction& action,
                      bool is_verbose) {
  Reasons reasons = {"it is the first step of the best plan to " +
                     GoalText(basis)};
  Append(CoveringRules(basis.problem, action, basis.state), &reasons);
  Append(FailureReasons(basis), &reasons);
  Append(AlternativeReasons(basis, action, is_verbose), &reasons);
  reasons.push_back("the plan: " + PlanText(basis.plan, *basis.problem.rules));
  return reasons;
}

/// True if it is tried because its rule was learned from little.
bool IsExploring(const DecisionBasis& basis, const GroundAction& action) {
  return basis.exploration &&
         planner::LeastTried(*basis.problem.rules, basis.state,
                             basis.not_to_begin,
                             basis.exploration->known_count) == action;
}

Reasons WhyTried(const DecisionBasis& basis, const GroundAction& action) {
  Reasons reasons = {fmt::format(
      "the cell learns, and knows little of it: a rule is known that was "
      "learned from {} experiences",
      basis.exploration->known_count)};
  Append(CoveringRules(basis.problem, action, basis.state), &reasons);
  return reasons;
}

Reasons WhyBeforeItsTurn(const DecisionBasis& basis, const GroundAction& action,
                         const State& state, size_t place) {
  Reasons reasons = {
      fmt::format("it hands over beforehand what step {} of the plan is for, "
                  "while the other arm works: it is possible now, and changes "
                  "nothing that the other needs",
                  place + 1)};
  Append(CoveringRules(basis.problem, action, state), &reasons);
  reasons.push_back("the plan: " + PlanText(basis.plan, *basis.problem.rules));
  return reasons;
}

/// It was chosen although there is no plan.
Reasons WhyMeanwhile(const DecisionBasis& basis, const GroundAction& action,
                     const State& state, bool is_verbose) {
  Reasons reasons;
  const Reasons rules = CoveringRules(basis.problem, action, state);
  if (rules.empty()) {
    reasons.emplace_back(
        "no plan is known: a rule without the conditions that fail is tried, "
        "since no experience speaks against it");
    Append(NearestRule(basis.problem, action, state.UnknownAsFalse()),
           &reasons);
  } else {
    reasons.emplace_back(
        "it brings some of the goal about without depending on what a person "
        "is needed for, and is done meanwhile");
    Append(rules, &reasons);
  }
  Append(NoPlanReasons(basis, basis.state, basis.plan), &reasons);
  if (is_verbose) Append(AlternativeReasons(basis, action, true), &reasons);
  return reasons;
}

Reasons WhyAction(const DecisionBasis& basis, const GroundAction& action,
                  const State& state, bool is_verbose) {
  if (IsExploring(basis, action)) return WhyTried(basis, action);
  const auto place = PlaceOf(action, basis.plan);
  if (place == 0) return WhyBestAction(basis, action, is_verbose);
  return place ? WhyBeforeItsTurn(basis, action, state, *place)
               : WhyMeanwhile(basis, action, state, is_verbose);
}

std::string ShowRequest(const SkillRequest& request,
                        const Vocabulary& vocabulary) {
  Reasons arguments;
  for (const auto& [name, object] : request.arguments) {
    arguments.push_back(vocabulary.objects()[object].name);
  }
  return fmt::format("the {} arm was asked to {}({})",
                     vocabulary.objects()[request.arm].name, request.skill,
                     fmt::join(arguments, ", "));
}

}  // namespace

planner::DecisionObserver DecisionExplainer::Observer() {
  return [this](planner::Instant now, const Decisions& decisions,
                const std::optional<DecisionBasis>& basis) {
    observed_.push_back({now.utime, decisions, basis});
  };
}

std::vector<int64_t> DecisionExplainer::Utimes() const {
  std::vector<int64_t> utimes;
  for (const Observed& observed : observed_) {
    const Decisions& decisions = observed.decisions;
    if (!observed.basis) continue;
    if (!decisions.requests.empty() || IsQuestion(decisions)) {
      utimes.push_back(observed.utime);
    }
    if (decisions.plan) utimes.push_back(decisions.plan->utime);
    for (const Alert& alert : decisions.alerts) {
      if (IsExplained(alert)) utimes.push_back(alert.utime);
    }
  }
  return utimes;
}

std::vector<Explanation> DecisionExplainer::At(int64_t utime) const {
  std::vector<Explanation> explanations;
  for (const Observed& observed : observed_) {
    if (!observed.basis) continue;
    for (Explanation& explanation : Explain(observed, utime)) {
      explanations.push_back(std::move(explanation));
    }
  }
  return explanations;
}

std::vector<Explanation> DecisionExplainer::Explain(const Observed& observed,
                                                    int64_t utime) const {
  std::vector<Explanation> explanations;
  const Decisions& decisions = observed.decisions;
  if (observed.utime == utime) {
    for (const SkillRequest& request : decisions.requests) {
      explanations.push_back(ExplainRequest(observed, request));
    }
    if (IsQuestion(decisions)) {
      explanations.push_back(ExplainQuestion(observed));
    }
  }
  for (const Alert& alert : decisions.alerts) {
    if (alert.utime == utime && IsExplained(alert)) {
      explanations.push_back(ExplainAlert(observed, alert));
    }
  }
  if (decisions.plan && decisions.plan->utime == utime) {
    explanations.push_back(ExplainPlan(observed));
  }
  return explanations;
}

Explanation DecisionExplainer::ExplainRequest(
    const Observed& observed, const SkillRequest& request) const {
  const DecisionBasis& basis = *observed.basis;
  const RuleSet& rules = *basis.problem.rules;
  Explanation explanation{
      observed.utime, ShowRequest(request, rules.vocabulary()), {}};
  if (request.purpose == SkillRequest::Purpose::kCleanUp) {
    explanation.reasons = {
        basis.plan.result == Plan::Result::kGoalReached
            ? GoalText(basis) +
                  " is reached: grippers are emptied, arms go home"
            : "it leaves room for the person who is asked"};
    return explanation;
  }
  if (request.purpose == SkillRequest::Purpose::kGoFree) {
    explanation.reasons = {
        "its skill was interrupted: what it holds may be under strain"};
    return explanation;
  }
  const auto running = basis.running.find(request.arm);
  if (running == basis.running.end() || !running->second.action) {
    return explanation;
  }
  const GroundAction& action = *running->second.action;
  explanation.what += ", which is " + rules.Show(action);
  explanation.reasons =
      WhyAction(basis, action, running->second.before, is_verbose_);
  return explanation;
}

Explanation DecisionExplainer::ExplainQuestion(const Observed& observed) const {
  const auto& question = *observed.decisions.execution;
  return {observed.utime, "the robot asked: " + question.text,
          QuestionReasons(*observed.basis, question, is_verbose_)};
}

Explanation DecisionExplainer::ExplainAlert(const Observed& observed,
                                            const Alert& alert) {
  Explanation explanation{alert.utime, "it was warned: " + alert.text, {}};
  if (alert.judgement) {
    explanation.reasons = ComparePlans(*observed.basis, *alert.judgement);
  }
  return explanation;
}

Explanation DecisionExplainer::ExplainPlan(const Observed& observed) const {
  const DecisionBasis& basis = *observed.basis;
  const planner::PlanOfState& of_state = *observed.decisions.plan;
  const Plan& plan = of_state.plan;
  Explanation explanation{
      of_state.utime,
      fmt::format(
          "this was the plan for {} (key frame {}): {}",
          basis.problem.agent == Agent::kPerson ? "the person" : "the robot",
          of_state.key_frame, PlanText(plan, *basis.problem.rules)),
      {}};
  if (HasNoPlan(plan)) {
    explanation.reasons = FailureReasons(basis);
    Append(NoPlanReasons(basis, basis.state, plan), &explanation.reasons);
  } else if (!plan.steps.empty()) {
    explanation.reasons =
        WhyBestAction(basis, plan.steps[0].action, is_verbose_);
    explanation.reasons.pop_back();  // the plan
  }
  return explanation;
}

}  // namespace cell::cli
