#pragma once

#include <vector>

#include "common/planning/bound_search.h"
#include "common/planning/explored_graph.h"
#include "common/planning/probability_bounds.h"

namespace cell::planning {

/// Among the policies that reach the goal with the highest probability P finds
/// one of the least expected number of actions C given that it is reached. With
/// W = P C this is a shortest path problem in which an action costs P(s) in s:
///   W(s) = P(s) + min over best a of sum over s' of T(s, a, s') W(s')
/// LAO* (Hansen and Zilberstein, 2001) from below, W(s) = P(s) h_max(s) at
/// first. A choice is best unless its upper bound says otherwise; the bounds
/// are narrowed first wherever the search comes.
class ActionSearch {
 public:
  ActionSearch(ExploredGraph* graph, ProbabilityBounds* bounds,
               BoundSearch* bound_search)
      : graph_(*graph), bounds_(*bounds), bound_search_(*bound_search) {}

  /// Makes a policy from the state. Returns true if it is a best one of the
  /// fewest actions; false if the budget was spent before: then
  /// MakeSafePolicy() still finds one.
  bool Minimize(int state, double precision, const Budget& budget,
                const MayGoOn& may_go_on = {});
  /// A policy that reaches the goal with the lower bound of the probability,
  /// from what is known.
  void MakeSafePolicy(int state);

  void Save(StateWriter* out) const;
  /// @param is_minimizing  the next Minimize() goes on with the one that was
  ///                       going on
  /// @throws as StateReader does
  void Restore(StateReader* in, bool is_minimizing);

  /// What the policy does in a state: a choice; -1 where it does nothing.
  int ChoiceIn(int state) const;

  struct Value {
    double probability = 0;
    double expected_actions = 0;  ///< given that the goal is reached
  };
  /// Of the policy, by itself.
  Value Evaluate(int state) const;

 private:
  struct Node {
    double cost = 0;  ///< W, from below
    int choice = -1;
    int64_t round = 0;  ///< in which it was visited last; 0: never
  };

  Node& NodeOf(int state) { return nodes_[static_cast<size_t>(state)]; }
  double CostOf(int state);
  double CostOf(const ExploredGraph::Choice& choice);
  bool IsAllowed(const ExploredGraph::Choice& choice);
  bool Run(int state, const MayGoOn& may_go_on);
  /// States of the policy, successors first where they form no cycle.
  std::vector<int> Collect(int state);
  bool Prepare(int state);
  double Improve(int state);

  ExploredGraph& graph_;
  ProbabilityBounds& bounds_;
  BoundSearch& bound_search_;
  Budget budget_;
  double precision_ = 0;
  bool is_safe_ = false;
  bool is_spent_ = false;
  bool has_new_ = false;
  bool is_restored_ = false;
  int64_t round_ = 0;
  int64_t first_round_ = 1;  // of this run
  std::vector<Node> nodes_;
};

}  // namespace cell::planning
