#include "common/planning/rollout.h"

#include <algorithm>
#include <optional>
#include <random>
#include <vector>

namespace cell::planning {
namespace {

/// In [0, 1), the same on every platform.
double Uniform(std::mt19937_64& generator) {
  return static_cast<double>(generator() >> 11) * 0x1p-53;
}

class Simulation {
 public:
  Simulation(const Model& model, const Planner& planner, uint64_t seed)
      : model_(model),
        planner_(planner),
        expansion_(model.num_words()),
        generator_(seed) {}

  /// The actions of a run that reached the goal.
  std::optional<int> Run(Bits start, int max_actions) {
    std::vector<uint64_t> state(start.begin(), start.end());
    for (int i = 0; !model_.IsGoal(state); ++i) {
      const std::optional<int> action = planner_.ActionIn(state);
      if (!action || i == max_actions || !Do(*action, &state)) {
        return std::nullopt;
      }
      num_actions_ = i + 1;
    }
    return model_.IsGoal(start) ? 0 : num_actions_;
  }

 private:
  bool Do(int action, std::vector<uint64_t>* state) {
    expansion_.Clear();
    model_.Expand(*state, &expansion_);
    const auto choice = std::ranges::find(expansion_.choices(), action,
                                          &Expansion::Choice::action);
    if (choice == expansion_.choices().end()) return false;
    double left = Uniform(generator_);
    int outcome = choice->first_outcome;
    const int last = outcome + choice->num_outcomes - 1;
    while (outcome < last && left >= expansion_.probability(outcome)) {
      left -= expansion_.probability(outcome++);
    }
    const Bits next = expansion_.state(outcome);
    state->assign(next.begin(), next.end());
    return true;
  }

  const Model& model_;
  const Planner& planner_;
  Expansion expansion_;
  std::mt19937_64 generator_;
  int num_actions_ = 0;
};

}  // namespace

Rollouts RollOut(const Model& model, const Planner& planner, Bits start,
                 int num_runs, uint64_t seed, int max_actions) {
  Simulation simulation(model, planner, seed);
  Rollouts rollouts{num_runs, 0, 0};
  double sum = 0;
  for (int i = 0; i < num_runs; ++i) {
    const std::optional<int> num_actions = simulation.Run(start, max_actions);
    if (!num_actions) continue;
    ++rollouts.num_reached;
    sum += *num_actions;
  }
  if (rollouts.num_reached > 0) {
    rollouts.mean_actions = sum / rollouts.num_reached;
  }
  return rollouts;
}

}  // namespace cell::planning
