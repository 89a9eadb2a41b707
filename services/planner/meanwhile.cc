#include "services/planner/meanwhile.h"

#include <memory>
#include <vector>

#include "services/planner/outcome_prediction.h"

namespace cell::planner {
namespace {

/// The state once a person has helped.
State Helped(State state, const std::vector<RequiredChange>& needed) {
  for (const RequiredChange& change : needed) {
    state.Set(change.atom, change.truth);
  }
  return state;
}

}  // namespace

std::optional<GroundAction> StepMeanwhile(
    const CurrentPlan& plan, const State& state,
    const std::set<GroundAction>& blocked) {
  const std::vector<RequiredChange>& needed = plan.get().needed;
  const std::unique_ptr<Solver> solver = plan.MakeUnblocked();
  const Plan helped = solver->Find(Helped(state, needed));
  for (const PlanStep& step : helped.steps) {
    if (blocked.contains(step.action) ||
        !IsSurelyPossible(plan.rules(), step.action, state)) {
      continue;
    }
    const auto after = MostLikelyOutcome(plan.rules(), step.action, state);
    if (!after) continue;
    const Plan rest = solver->Find(Helped(*after, needed));
    if (rest.result == Plan::Result::kGoalReached ||
        rest.probability >= helped.probability) {
      return step.action;
    }
  }
  return std::nullopt;
}

}  // namespace cell::planner
