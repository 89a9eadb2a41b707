#include "common/planning/causal_graph.h"

namespace cell::planning {

CausalGraph::CausalGraph(const GroundTask& task)
    : task_(task),
      producers_(2 * task.atoms.size()),
      is_of_goal_(2 * task.atoms.size()) {
  for (const GroundAction& action : task.actions) {
    for (const Outcome& outcome : action.outcomes) {
      for (const ConditionalEffect& effect : outcome.effects) {
        const int index = static_cast<int>(rules_.size());
        rules_.push_back({{&action.precondition, &effect.when}, &effect.then});
        for (const Literal& l : effect.then) {
          std::vector<int>& producers = producers_[Index(l)];
          if (producers.empty() || producers.back() != index) {
            producers.push_back(index);
          }
        }
      }
    }
  }
  for (const Conjunction& goal : task.goals) {
    for (const Literal& l : goal.literals) is_of_goal_[Index(l)] = true;
    for (const auto& clause : goal.clauses) {
      for (const Literal& l : clause) is_of_goal_[Index(l)] = true;
    }
  }
}

}  // namespace cell::planning
