#pragma once

#include <functional>
#include <vector>

#include "common/planning/causal_graph.h"
#include "common/planning/ground_task.h"

namespace cell::planning {

/// The delete relaxation of a task from its initial state with further
/// literals, layer by layer, and regression over what it does not reach.
class Regression {
 public:
  /// What keeps the goal from being reached.
  struct Gap {
    /// Whatever makes the goal reachable adds one of these, in the order of
    /// regression; empty if nothing does.
    std::vector<Literal> literals;
    /// Whatever makes the goal reachable adds at least so many.
    int least_changes = 0;
  };

  /// @param graph  of the task; must outlive it
  Regression(const CausalGraph& graph, const std::vector<Literal>& added);

  bool Has(const Literal& literal) const { return LayerOf(literal) >= 0; }
  bool HasGoal() const;

  /// From the goal back over the actions to what is not reached. Of several
  /// literals that a condition lacks, all are needed: it goes back from that
  /// one which leaves the fewest literals to choose from.
  /// @param may_add  the literals that can be added at all
  /// Only if the goal is not reached.
  Gap FindGap(const std::function<bool(const Literal&)>& may_add) const;

  /// The literals that a goal rests on where `base`, which lacks the added
  /// ones, does not go: see Excuse::subgoals.
  std::vector<Literal> SubgoalsWithin(const Regression& base) const;

  /// True if the action's precondition, or that of one of its effects, speaks
  /// of the literal and is reached.
  bool AppliesBy(const GroundAction& action, const Literal& literal) const;

 private:
  using Literals = std::vector<Literal>;

  int LayerOf(const Literal& literal) const {
    return layer_[CausalGraph::Index(literal)];
  }
  bool Has(const Conjunction& condition) const;
  /// The layer in which a condition is reached; -1: never.
  int LayerOf(const Conjunction& condition) const;
  /// The literals of a condition by which it is reached.
  std::vector<Literal> SupportOf(const Conjunction& condition) const;
  /// What the condition lacks: of each element, one literal has to be reached.
  std::vector<Literals> MissingOf(const Conjunction& condition) const;
  /// Of what a rule lacks, the literals to go back from: those that are seen
  /// already, or that the fewest rules bring about.
  Literals NextOf(const CausalGraph::Rule& rule,
                  const std::vector<bool>& is_seen) const;
  /// Literals of which one is added if one of `wanted` is to be reached.
  Literals Regress(const Literals& wanted) const;

  const CausalGraph& graph_;
  std::vector<int> layer_;
};

}  // namespace cell::planning
