#include "services/planner/plan_search.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "services/planner/unlearned.h"

namespace cell::planner {
namespace {

constexpr size_t kMaxNamedUnknowns = 5;

/// Values without the last digits, which depend on the order of questions.
double Rounded(double value) {
  return std::round(value * 1e9) / 1e9;
}

std::string WhyNotLearned(const std::vector<Literal>& unlearned,
                          const Vocabulary& vocabulary) {
  std::vector<std::string> names;
  for (const Literal& literal : unlearned) {
    names.push_back(Show(literal, {}, vocabulary));
  }
  return fmt::format("no action is known after which {} would hold",
                     fmt::join(names, ", or "));
}

}  // namespace

PlanSearch::PlanSearch(Problem problem, const Params& params)
    : problem_(std::move(problem)),
      params_(params),
      goal_(problem_.goal.literals, {}, problem_.rules->vocabulary()),
      space_(problem_.rules, problem_.agent, problem_.blocked) {}

SolverMaker PlanSearch::Maker(const Params& params) {
  return [params](Problem problem) {
    return std::make_unique<PlanSearch>(std::move(problem), params);
  };
}

Plan PlanSearch::Find(const State& state) {
  Plan plan = FindWithoutReason(state);
  if (plan.result != Plan::Result::kNoPlan) return plan;
  Excuse excuse = WhyNoPlan(state.UnknownAsFalse());
  plan.reason = std::move(excuse.text);
  plan.needed = std::move(excuse.needed);
  return plan;
}

Plan PlanSearch::FindWithoutReason(const State& state) {
  if (auto unlearned = UnlearnedLiterals(problem_, state); !unlearned.empty()) {
    return {.result = Plan::Result::kNotLearned,
            .reason = WhyNotLearned(unlearned, vocabulary()),
            .unlearned = std::move(unlearned)};
  }
  Plan plan = Solve(state.UnknownAsFalse());
  const bool is_surely_reached = std::all_of(
      problem_.goal.literals.begin(), problem_.goal.literals.end(),
      [&](const Literal& l) { return MustHold(l, {}, state, vocabulary()); });
  if (plan.result == Plan::Result::kGoalReached && !is_surely_reached) {
    plan.result = Plan::Result::kUndecided;
    plan.reason = WhyUndecided(state);
  }
  if (plan.result != Plan::Result::kNoPlan) return plan;
  if (state.HasUnknown() && Solve(state).result != Plan::Result::kNoPlan) {
    plan.result = Plan::Result::kUndecided;
    plan.reason = WhyUndecided(state);
  }
  return plan;
}

Plan PlanSearch::Solve(const State& state) {
  Plan plan;
  const std::optional<int> s = Enter(state);
  if (!s) {
    plan.reason = fmt::format(
        "more than {} states can be reached from here; allow more states, or "
        "describe the task with fewer predicates",
        params_.max_states);
    return plan;
  }
  const ValueIteration::Value& value = values_.Of(*s);
  plan.probability = Rounded(value.probability);
  plan.expected_actions = Rounded(value.expected_actions);
  plan.steps = LikelyCourse(*s);
  plan.next = NextSteps(*s);
  plan.result = is_goal_[*s]            ? Plan::Result::kGoalReached
                : value.probability > 0 ? Plan::Result::kFound
                                        : Plan::Result::kNoPlan;
  return plan;
}

std::optional<int> PlanSearch::Enter(const State& state) {
  std::optional<int> entered = space_.Enter(state, params_.max_states);
  if (!entered) {  // the states of earlier questions may have filled it
    values_.Clear();
    is_goal_.clear();
    entered = space_.Enter(state, params_.max_states);
    if (!entered) return std::nullopt;
  }
  for (int s = static_cast<int>(is_goal_.size()); s < space_.size(); ++s) {
    is_goal_.push_back(goal_.MayHold(space_.state(s)));
  }
  values_.Extend(space_, is_goal_);
  return entered;
}

std::vector<PlanStep> PlanSearch::LikelyCourse(int state) const {
  std::vector<PlanStep> steps;
  std::set<int> visited;
  while (!is_goal_[state] && visited.insert(state).second) {
    const int best = values_.Best(space_, state);
    if (best < 0) break;
    const StateSpace::Candidate& candidate = space_.candidates(state)[best];
    const auto likeliest = std::max_element(
        candidate.moves.begin(), candidate.moves.end(),
        [&](const StateSpace::Move& a, const StateSpace::Move& b) {
          return a.probability * values_.Of(a.state).probability <
                 b.probability * values_.Of(b.state).probability;
        });
    const ValueIteration::Value value = values_.Of(candidate, state);
    steps.push_back({space_.actions()[candidate.action], likeliest->probability,
                     Rounded(value.expected_actions)});
    state = likeliest->state;
  }
  return steps;
}

std::vector<Alternative> PlanSearch::Ranked(int state) const {
  std::vector<Alternative> ranked;
  for (const StateSpace::Candidate& candidate : space_.candidates(state)) {
    const ValueIteration::Value value = values_.Of(candidate, state);
    double likeliest = 0;
    for (const StateSpace::Move& move : candidate.moves) {
      if (values_.Of(move.state).probability <= 0) continue;
      likeliest = std::max(likeliest, move.probability);
    }
    ranked.push_back({{space_.actions()[candidate.action], likeliest,
                       Rounded(value.expected_actions)},
                      Rounded(value.probability)});
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const Alternative& a, const Alternative& b) {
                     if (a.probability != b.probability) {
                       return a.probability > b.probability;
                     }
                     return a.step.expected_actions < b.step.expected_actions;
                   });
  return ranked;
}

std::vector<PlanStep> PlanSearch::NextSteps(int state) const {
  std::vector<PlanStep> next;
  for (const Alternative& alternative : Ranked(state)) {
    if (alternative.step.probability > 0) next.push_back(alternative.step);
  }
  return next;
}

std::vector<Alternative> PlanSearch::Alternatives(const State& state) {
  const std::optional<int> s = Enter(state.UnknownAsFalse());
  return s ? Ranked(*s) : std::vector<Alternative>();
}

Excuse PlanSearch::WhyNoPlan(const State& state) {
  const std::optional<int> s = Enter(state);
  if (!s) return {"too many states to explain", {}};
  return ExplainNoPlan(problem_, space_, *s,
                       [this](const State& other) { return Solve(other); });
}

std::string PlanSearch::WhyUndecided(const State& state) const {
  const std::vector<int> unknown = state.UnknownAtoms();
  std::string names;
  for (size_t i = 0; i < unknown.size() && i < kMaxNamedUnknowns; ++i) {
    names += (i > 0 ? ", " : "") + vocabulary().AtomName(unknown[i]);
  }
  if (unknown.size() > kMaxNamedUnknowns) {
    names += fmt::format(" and {} more", unknown.size() - kMaxNamedUnknowns);
  }
  return "it is not known whether a plan leads to the goal, because these are "
         "unknown: " +
         names;
}

}  // namespace cell::planner
