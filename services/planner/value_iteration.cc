#include "services/planner/value_iteration.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cell::planner {
namespace {

constexpr double kConverged = 1e-13;  // largest change in a sweep
constexpr double kEqual = 1e-9;       // values that count as equal
constexpr int kMaxSweeps = 1'000'000;

/// Sweeps from the last state to the first, since goals are found late, until
/// update(state), which returns the change it made, changes nothing.
template <class Update>
void SweepUntilStill(int first, int last, Update update) {
  for (int sweep = 0; sweep < kMaxSweeps; ++sweep) {
    double change = 0;
    for (int state = last; state-- > first;) {
      change = std::max(change, update(state));
    }
    if (change < kConverged) return;
  }
}

}  // namespace

void ValueIteration::Extend(const StateSpace& space,
                            const std::vector<bool>& is_goal) {
  const int first = static_cast<int>(values_.size());
  const int last = space.size();
  values_.resize(last);
  for (int s = first; s < last; ++s) {
    if (is_goal.at(s)) values_[s].probability = 1;
  }
  SweepUntilStill(first, last, [&](int s) {
    if (is_goal[s]) return 0.0;
    double best = 0;
    for (const StateSpace::Candidate& candidate : space.candidates(s)) {
      best = std::max(best, ProbabilityOf(candidate));
    }
    const double change = best - values_[s].probability;
    values_[s].probability = best;
    return change;
  });
  SweepUntilStill(first, last, [&](int s) {
    if (is_goal[s] || values_[s].probability <= 0) return 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (const StateSpace::Candidate& candidate : space.candidates(s)) {
      if (ProbabilityOf(candidate) < values_[s].probability - kEqual) continue;
      least = std::min(least, ActionsOf(candidate, s));
    }
    const double change = std::abs(least - values_[s].expected_actions);
    values_[s].expected_actions = least;
    return change / std::max(1.0, least);
  });
}

/// sum p P(s') / (1 - stay): staying and trying again until something happens.
double ValueIteration::ProbabilityOf(
    const StateSpace::Candidate& candidate) const {
  double sum = 0;
  double moving = 0;  // 1 - stay
  for (const StateSpace::Move& move : candidate.moves) {
    sum += move.probability * values_[move.state].probability;
    moving += move.probability;
  }
  return sum / moving;
}

/// Solves C = 1 + stay C + sum p P(s')/P C(s') for C, for a candidate that has
/// the state's P.
double ValueIteration::ActionsOf(const StateSpace::Candidate& candidate,
                                 int state) const {
  double sum = 1;
  double moving = 0;  // 1 - stay
  for (const StateSpace::Move& move : candidate.moves) {
    const Value& after = values_[move.state];
    sum += move.probability * after.probability / values_[state].probability *
           after.expected_actions;
    moving += move.probability;
  }
  return sum / moving;
}

ValueIteration::Value ValueIteration::Of(const StateSpace::Candidate& candidate,
                                         int state) const {
  Value value;
  const auto add = [&](double probability, const Value& after) {
    const double share = probability * after.probability;
    value.probability += share;
    value.expected_actions += share * (1 + after.expected_actions);
  };
  add(candidate.stay, values_.at(state));
  for (const StateSpace::Move& move : candidate.moves) {
    add(move.probability, values_[move.state]);
  }
  if (value.probability > 0) value.expected_actions /= value.probability;
  return value;
}

int ValueIteration::Best(const StateSpace& space, int state) const {
  const Value& value = values_.at(state);
  const auto& candidates = space.candidates(state);
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  if (value.probability <= 0 || value.expected_actions <= 0) return best;
  for (size_t i = 0; i < candidates.size(); ++i) {
    if (ProbabilityOf(candidates[i]) < value.probability - kEqual) continue;
    const double actions = ActionsOf(candidates[i], state);
    if (actions < least - kEqual) {
      least = actions;
      best = static_cast<int>(i);
    }
  }
  return best;
}

}  // namespace cell::planner
