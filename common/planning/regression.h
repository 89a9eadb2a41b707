#pragma once

#include <functional>
#include <set>
#include <vector>

#include "common/planning/ground_task.h"

namespace cell::planning {

/// The delete relaxation of a task from its initial state with further
/// literals, layer by layer, and regression over what it does not reach.
class Regression {
 public:
  Regression(const GroundTask& task, const std::vector<Literal>& added);

  bool Has(const Literal& literal) const { return LayerOf(literal) >= 0; }
  bool HasGoal() const;

  /// The literals that are not reached and from which actions that never apply
  /// lead to the goal, in the order of regression. Empty if the goal is
  /// reached; if not, whatever makes it reachable adds one of them.
  std::vector<Literal> Missing() const;

  /// The literals that a goal rests on where `base`, which lacks the added
  /// ones, does not go: see Excuse::subgoals.
  std::vector<Literal> SubgoalsWithin(const Regression& base) const;

  /// True if the action's precondition, or that of one of its effects, speaks
  /// of the literal and is reached.
  bool AppliesBy(const GroundAction& action, const Literal& literal) const;

 private:
  /// An effect of an action, and the condition of both.
  struct Rule {
    std::vector<const Conjunction*> conditions;
    const std::vector<Literal>* then;
  };

  static size_t Index(const Literal& literal) {
    return 2 * static_cast<size_t>(literal.atom) + (literal.value ? 1 : 0);
  }
  int LayerOf(const Literal& literal) const { return layer_[Index(literal)]; }
  bool Has(const Conjunction& condition) const;
  /// The layer in which a condition is reached; -1: never.
  int LayerOf(const Conjunction& condition) const;
  /// The literals of a condition by which it is reached.
  std::vector<Literal> SupportOf(const Conjunction& condition) const;
  /// Literals that keep the condition from being reached.
  void AddMissing(const Conjunction& condition,
                  std::vector<Literal>* missing) const;

  const GroundTask& task_;
  std::vector<Rule> rules_;
  std::vector<int> layer_;
};

}  // namespace cell::planning
