#pragma once

#include <vector>

#include "common/planning/ground_task.h"

namespace cell::planning {

/// The effects of a task's actions, and which of them bring a literal about.
class CausalGraph {
 public:
  /// An effect of an action, and the conditions of both.
  struct Rule {
    std::vector<const Conjunction*> conditions;
    const std::vector<Literal>* then;
  };

  /// @param task  must outlive it
  explicit CausalGraph(const GroundTask& task);

  const GroundTask& task() const { return task_; }
  const std::vector<Rule>& rules() const { return rules_; }
  /// Indices of rules, ascending.
  const std::vector<int>& ProducersOf(const Literal& literal) const {
    return producers_[Index(literal)];
  }
  /// True if the goal asks for it, alone or among others.
  bool IsOfGoal(const Literal& literal) const {
    return is_of_goal_[Index(literal)];
  }

  /// The place of a literal among all, [0, num_literals()).
  static size_t Index(const Literal& literal) {
    return 2 * static_cast<size_t>(literal.atom) + (literal.value ? 1 : 0);
  }
  size_t num_literals() const { return producers_.size(); }

 private:
  const GroundTask& task_;
  std::vector<Rule> rules_;
  std::vector<std::vector<int>> producers_;  // by Index()
  std::vector<bool> is_of_goal_;             // by Index()
};

}  // namespace cell::planning
