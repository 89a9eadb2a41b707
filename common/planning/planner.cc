#include "common/planning/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <istream>
#include <ostream>
#include <set>
#include <stdexcept>
#include <utility>

#include "common/planning/action_search.h"
#include "common/planning/bound_search.h"
#include "common/planning/explored_graph.h"
#include "common/planning/probability_bounds.h"
#include "common/text/counted.h"

namespace cell::planning {

class Planner::Search {
 public:
  Search(std::shared_ptr<const Model> model, const Params& params)
      : params_(params),
        graph_(std::move(model)),
        bounds_(&graph_),
        bound_search_(&graph_, &bounds_),
        action_search_(&graph_, &bounds_, &bound_search_) {}

  Plan Find(Bits state, const Watch& watch) {
    if (static_cast<int>(state.size()) != graph_.model().num_words()) {
      throw std::invalid_argument(
          fmt::format("a state of {} words; the model has {}", state.size(),
                      graph_.model().num_words()));
    }
    watch_ = watch;
    int64_t num_before = graph_.num_expansions();
    if (std::exchange(is_restored_, false)) {
      if (!std::ranges::equal(state, position_.start)) {
        throw std::invalid_argument("the saved search began in another state");
      }
      num_before = 0;
    } else {
      position_ = {Phase::kBounds, 0, {state.begin(), state.end()}};
    }
    budget_ = {num_before + params_.max_expansions, params_.max_bytes};
    const int start = graph_.Enter(state);
    bounds_.Extend();
    Plan plan;
    if (graph_.IsGoal(start)) {
      plan.status = Plan::Status::kGoalReached;
      plan.reason = "the goal is reached already";
      plan.probability = {1, 1};
      plan.is_shortest = true;
    } else {
      FindFrom(start, &plan);
    }
    plan.num_expansions = graph_.num_expansions() - num_before;
    plan.num_states = graph_.num_states();
    plan.num_bytes = graph_.num_bytes() + bounds_.num_bytes();
    return plan;
  }

  void Save(std::ostream* out) const {
    StateWriter writer(out);
    writer.Put(position_.phase);
    writer.Put(position_.minimize_from);
    writer.Put(position_.start);
    graph_.Save(&writer);
    bounds_.Save(&writer);
    bound_search_.Save(&writer);
    action_search_.Save(&writer);
    writer.PutChecksum();
  }

  void Restore(std::istream* in, uint64_t num_bytes) {
    StateReader reader(in, num_bytes);
    reader.Get(&position_.phase);
    reader.Get(&position_.minimize_from);
    reader.Get(&position_.start);
    graph_.Restore(&reader);
    bounds_.Restore(&reader);
    bound_search_.Restore(&reader);
    action_search_.Restore(&reader, position_.phase == Phase::kActions);
    reader.CheckChecksum();
    is_restored_ = true;
  }

  std::optional<int> ActionIn(Bits state) const {
    const std::optional<int> known = graph_.Find(state);
    const int choice = known ? action_search_.ChoiceIn(*known) : -1;
    if (choice < 0) return std::nullopt;
    return graph_.choice(choice).action;
  }

 private:
  enum class Phase : int { kBounds, kActions, kDone };
  /// Where the search of the last Find() is, beside what its parts know.
  struct Position {
    Phase phase = Phase::kBounds;
    int64_t minimize_from = 0;  ///< expansions before Phase::kActions
    std::vector<uint64_t> start;
  };

  /// Whether the search may go on.
  bool Report(int start, bool is_last) {
    return !watch_ || watch_({graph_.num_expansions(),
                              {bounds_.low(start), bounds_.high(start)},
                              is_last});
  }

  /// Returns true if no best policy needs fewer actions.
  bool Minimize(int start, const MayGoOn& may_go_on) {
    if (position_.phase == Phase::kBounds) {
      position_.phase = Phase::kActions;
      position_.minimize_from = graph_.num_expansions();
    }
    Budget budget = budget_;
    if (params_.max_minimize_expansions <
        budget.max_expansions - position_.minimize_from) {
      budget.max_expansions =
          position_.minimize_from + params_.max_minimize_expansions;
    }
    if (position_.phase == Phase::kActions &&
        action_search_.Minimize(start, params_.precision, budget, may_go_on)) {
      position_.phase = Phase::kDone;
    }
    return position_.phase == Phase::kDone;
  }

  void FindFrom(int start, Plan* plan) {
    const MayGoOn may_go_on = [&] {
      return Report(start, false);
    };
    const bool is_solved =
        bound_search_.Solve(start, params_.precision, budget_, may_go_on);
    plan->is_shortest = is_solved && bounds_.low(start) > 0 &&
                        params_.minimize_actions && Minimize(start, may_go_on);
    Report(start, true);
    if (bounds_.low(start) <= 0) {
      const bool is_proven = is_solved && !MayReachGoal(start);
      plan->probability = {0, is_proven ? 0 : bounds_.high(start)};
      plan->status =
          is_proven ? Plan::Status::kNoPlan : Plan::Status::kUndecided;
      plan->reason = is_proven ? "no sequence of actions reaches the goal, "
                                 "whatever their outcomes"
                               : WhyUndecided();
      return;
    }
    plan->status = Plan::Status::kFound;
    if (!plan->is_shortest) action_search_.MakeSafePolicy(start);
    const ActionSearch::Value value = action_search_.Evaluate(start);
    plan->expected_actions = value.expected_actions;
    plan->probability = {std::min(value.probability, bounds_.high(start)),
                         bounds_.high(start)};
    plan->course = CourseFrom(start);
    if (params_.solve_alternatives) SolveAlternatives(start);
    plan->alternatives = AlternativesIn(start);
  }

  /// Whether a goal is among the states that can be reached, or the budget is
  /// spent before all are known. A small upper bound alone proves nothing.
  bool MayReachGoal(int start) {
    std::vector<int> states = {start};
    std::set<int> seen = {start};
    for (size_t i = 0; i < states.size(); ++i) {
      const int s = states[i];
      if (graph_.IsGoal(s)) return true;
      if (bounds_.high(s) <= 0) continue;
      if (!bound_search_.TryExpand(s, budget_)) return true;
      const int first = graph_.first_choice(s);
      for (int c = first; c < first + graph_.num_choices(s); ++c) {
        for (const auto& outcome : graph_.outcomes(graph_.choice(c))) {
          if (seen.insert(outcome.state).second) {
            states.push_back(outcome.state);
          }
        }
      }
    }
    return false;
  }

  std::string WhyUndecided() const {
    return fmt::format(
        "no way to the goal was found within the budget; {} explored",
        Counted(graph_.num_states(), "state was", "states were"));
  }

  /// The outcome of the policy's choice that the course goes on with.
  ExploredGraph::Outcome LikelyOutcome(const ExploredGraph::Choice& choice) {
    ExploredGraph::Outcome best{-1, 0};
    double best_weight = -1;
    for (const auto& outcome : graph_.outcomes(choice)) {
      const double weight =
          outcome.state == choice.state
              ? 0
              : outcome.probability * bounds_.low(outcome.state);
      if (weight > best_weight) {
        best_weight = weight;
        best = outcome;
      }
    }
    return best;
  }

  std::vector<Step> CourseFrom(int state) {
    std::vector<Step> course;
    std::set<int> visited;
    while (!graph_.IsGoal(state) && visited.insert(state).second) {
      const int index = action_search_.ChoiceIn(state);
      if (index < 0) break;
      const ExploredGraph::Choice& choice = graph_.choice(index);
      const ExploredGraph::Outcome outcome = LikelyOutcome(choice);
      course.push_back({choice.action, graph_.model().ActionName(choice.action),
                        outcome.probability});
      state = outcome.state;
    }
    return course;
  }

  void SolveAlternatives(int start) {
    // Copies, since the graph grows.
    std::vector<int> next;
    const int first = graph_.first_choice(start);
    for (int c = first; c < first + graph_.num_choices(start); ++c) {
      for (const auto& outcome : graph_.outcomes(graph_.choice(c))) {
        next.push_back(outcome.state);
      }
    }
    for (const int state : next) {
      bound_search_.Solve(state, params_.precision, budget_);
    }
  }

  std::vector<Alternative> AlternativesIn(int start) {
    std::vector<Alternative> alternatives;
    const int chosen = action_search_.ChoiceIn(start);
    const int first = graph_.first_choice(start);
    for (int c = first; c < first + graph_.num_choices(start); ++c) {
      const ExploredGraph::Choice& choice = graph_.choice(c);
      Alternative alternative{
          choice.action, graph_.model().ActionName(choice.action), {0, 0}};
      for (const auto& [next, probability] : graph_.outcomes(choice)) {
        alternative.probability.low += probability * bounds_.low(next);
        alternative.probability.high += probability * bounds_.high(next);
      }
      if (alternative.probability.high <= 0) continue;
      alternatives.push_back(std::move(alternative));
      if (c == chosen)
        std::ranges::rotate(alternatives, alternatives.end() - 1);
    }
    if (chosen >= 0) {
      std::stable_sort(alternatives.begin() + 1, alternatives.end(),
                       [](const Alternative& a, const Alternative& b) {
                         return a.probability.high > b.probability.high;
                       });
    }
    return alternatives;
  }

  Params params_;
  Watch watch_;
  Budget budget_;
  bool is_restored_ = false;
  Position position_;
  ExploredGraph graph_;
  ProbabilityBounds bounds_;
  BoundSearch bound_search_;
  ActionSearch action_search_;
};

Planner::Planner(std::shared_ptr<const Model> model, const Params& params)
    : search_(std::make_unique<Search>(std::move(model), params)) {}

Planner::~Planner() = default;

Plan Planner::Find(Bits state, const Watch& watch) {
  return search_->Find(state, watch);
}

void Planner::Save(std::ostream* out) const {
  search_->Save(out);
}

void Planner::Restore(std::istream* in, uint64_t num_bytes) {
  search_->Restore(in, num_bytes);
}

std::optional<int> Planner::ActionIn(Bits state) const {
  return search_->ActionIn(state);
}

}  // namespace cell::planning
