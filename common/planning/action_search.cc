#include "common/planning/action_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cell::planning {
namespace {

constexpr double kTolerance = 1e-10;
constexpr int kMaxSweepsPerRound = 50;
constexpr int kMaxRounds = 100'000;
constexpr int kMaxEvaluationSweeps = 1'000'000;
constexpr double kEvaluated = 1e-14;

/// The sum of probability times value over the outcomes that leave `state`,
/// and the probability of those.
template <class ValueOf>
std::pair<double, double> Expected(
    std::span<const ExploredGraph::Outcome> outcomes, int state,
    ValueOf value_of) {
  double sum = 0;
  double leaving = 0;
  for (const auto& [next, probability] : outcomes) {
    if (next == state) continue;
    leaving += probability;
    sum += probability * value_of(next);
  }
  return {sum, leaving};
}

}  // namespace

double ActionSearch::CostOf(int state) {
  if (graph_.IsGoal(state)) return 0;
  if (static_cast<size_t>(state) < nodes_.size() &&
      NodeOf(state).round >= first_round_) {
    return NodeOf(state).cost;
  }
  return bounds_.low(state) * std::max(1.0, graph_.least_actions(state));
}

double ActionSearch::CostOf(const ExploredGraph::Choice& choice) {
  const auto [sum, leaving] =
      Expected(graph_.outcomes(choice), choice.state,
               [this](int next) { return CostOf(next); });
  return (bounds_.low(choice.state) + sum) / leaving;
}

bool ActionSearch::IsAllowed(const ExploredGraph::Choice& choice) {
  const auto [sum, leaving] =
      Expected(graph_.outcomes(choice), choice.state, [this](int next) {
        return is_safe_ ? bounds_.low(next) : bounds_.high(next);
      });
  const double slack = is_safe_ ? 1e-12 : std::max(2 * precision_, 1e-9);
  return sum / leaving >= bounds_.low(choice.state) - slack;
}

double ActionSearch::Improve(int state) {
  Node& node = NodeOf(state);
  double best = -1;
  int best_choice = -1;
  const int first = graph_.first_choice(state);
  for (int c = first; c < first + graph_.num_choices(state); ++c) {
    if (!IsAllowed(graph_.choice(c))) continue;
    const double cost = CostOf(graph_.choice(c));
    if (best_choice < 0 || cost < best - kTolerance) {
      best = cost;
      best_choice = c;
    }
  }
  node.choice = best_choice;
  const double change = std::max(0.0, best - node.cost);
  node.cost = std::max(best, node.cost);
  return change / std::max(1.0, node.cost);
}

bool ActionSearch::Prepare(int state) {
  nodes_.resize(static_cast<size_t>(graph_.size()));
  if (NodeOf(state).round < first_round_) {
    has_new_ = true;
    NodeOf(state) = {CostOf(state), -1, 0};
  }
  NodeOf(state).round = round_;
  if (graph_.IsGoal(state) || bounds_.high(state) <= precision_) return false;
  if (is_safe_) return graph_.IsExpanded(state) && bounds_.low(state) > 0;
  if (!bound_search_.Solve(state, precision_, budget_) ||
      !bound_search_.TryExpand(state, budget_)) {
    is_spent_ = true;
    return false;
  }
  nodes_.resize(static_cast<size_t>(graph_.size()));
  return bounds_.low(state) > 0;
}

std::vector<int> ActionSearch::Collect(int state) {
  ++round_;
  std::vector<int> order;
  std::vector<std::pair<int, int>> frames;  // state, next outcome
  const auto open = [&](int s) {
    if (!Prepare(s)) return;
    Improve(s);
    frames.emplace_back(s, 0);
  };
  open(state);
  while (!frames.empty() && !is_spent_) {
    auto& [s, next] = frames.back();
    const int choice = NodeOf(s).choice;
    if (choice >= 0 && next < graph_.choice(choice).num_outcomes) {
      const auto outcomes = graph_.outcomes(graph_.choice(choice));
      const int target = outcomes[static_cast<size_t>(next++)].state;
      nodes_.resize(static_cast<size_t>(graph_.size()));
      if (NodeOf(target).round != round_) open(target);
    } else {
      order.push_back(s);
      frames.pop_back();
    }
  }
  return order;
}

bool ActionSearch::Run(int state, const MayGoOn& may_go_on) {
  if (!is_restored_) first_round_ = round_ + 1;
  is_restored_ = false;
  is_spent_ = false;
  for (int i = 0; i < kMaxRounds; ++i) {
    has_new_ = false;
    const std::vector<int> order = Collect(state);
    if (is_spent_) return false;
    double first_change = 0;
    for (int sweep = 0; sweep < kMaxSweepsPerRound; ++sweep) {
      double change = 0;
      for (const int s : order) {
        const int before = NodeOf(s).choice;
        change = std::max(change, Improve(s));
        // A choice that is new may lead out of the collected states.
        if (NodeOf(s).choice != before) change = std::max(change, 1.0);
      }
      if (sweep == 0) first_change = change;
      if (change < kTolerance) break;
    }
    if (!has_new_ && first_change < kTolerance) return true;
    if (may_go_on && !may_go_on()) return false;
  }
  return false;
}

bool ActionSearch::Minimize(int state, double precision, const Budget& budget,
                            const MayGoOn& may_go_on) {
  precision_ = precision;
  budget_ = budget;
  is_safe_ = false;
  return Run(state, may_go_on);
}

void ActionSearch::MakeSafePolicy(int state) {
  is_safe_ = true;
  Run(state, {});
}

void ActionSearch::Save(StateWriter* out) const {
  out->Put(round_);
  out->Put(first_round_);
  out->Put(nodes_);
}

void ActionSearch::Restore(StateReader* in, bool is_minimizing) {
  in->Get(&round_);
  in->Get(&first_round_);
  in->Get(&nodes_);
  is_restored_ = is_minimizing;
}

int ActionSearch::ChoiceIn(int state) const {
  const auto index = static_cast<size_t>(state);
  if (index >= nodes_.size() || nodes_[index].round < first_round_) return -1;
  return nodes_[index].choice;
}

ActionSearch::Value ActionSearch::Evaluate(int state) const {
  std::vector<int> order;
  std::vector<int> place(nodes_.size(), -1);
  std::vector<std::pair<int, int>> frames;
  const auto open = [&](int s) {
    place[static_cast<size_t>(s)] = 0;
    frames.emplace_back(s, 0);
  };
  if (static_cast<size_t>(state) < place.size()) open(state);
  while (!frames.empty()) {
    auto& [s, next] = frames.back();
    const int choice = ChoiceIn(s);
    if (choice >= 0 && next < graph_.choice(choice).num_outcomes) {
      const int target =
          graph_.outcomes(graph_.choice(choice))[static_cast<size_t>(next++)]
              .state;
      if (static_cast<size_t>(target) < place.size() &&
          place[static_cast<size_t>(target)] < 0) {
        open(target);
      }
    } else {
      place[static_cast<size_t>(s)] = static_cast<int>(order.size());
      order.push_back(s);
      frames.pop_back();
    }
  }
  // First the probabilities, then the costs, each from below.
  std::vector<double> probability(order.size()), cost(order.size());
  const auto sweep = [&](std::vector<double>& values, bool are_costs) {
    double change = 0;
    for (size_t i = 0; i < order.size(); ++i) {
      const int s = order[i];
      const int choice = ChoiceIn(s);
      if (graph_.IsGoal(s)) {
        values[i] = are_costs ? 0 : 1;
      } else if (choice >= 0) {
        const auto [sum, leaving] =
            Expected(graph_.outcomes(graph_.choice(choice)), s, [&](int next) {
              const auto index = static_cast<size_t>(next);
              if (index >= place.size() || place[index] < 0) return 0.0;
              return values[static_cast<size_t>(place[index])];
            });
        const double value = ((are_costs ? probability[i] : 0) + sum) / leaving;
        change = std::max(change,
                          std::abs(value - values[i]) / std::max(1.0, value));
        values[i] = value;
      }
    }
    return change;
  };
  for (int i = 0; i < kMaxEvaluationSweeps; ++i) {
    if (sweep(probability, false) < kEvaluated) break;
  }
  for (int i = 0; i < kMaxEvaluationSweeps; ++i) {
    if (sweep(cost, true) < kEvaluated) break;
  }
  if (order.empty() || probability.back() <= 0) return {};
  return {probability.back(), cost.back() / probability.back()};
}

}  // namespace cell::planning
