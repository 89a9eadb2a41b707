#pragma once

#include <cstdint>
#include <memory>

#include "common/planning/explored_graph.h"

namespace cell::planning {

/// Finds out whether a goal can be reached at all: greedy best-first search in
/// which every outcome can be chosen. Keeps what it has explored.
class GoalSearch {
 public:
  enum class Answer { kYes, kNo, kUndecided };

  explicit GoalSearch(std::shared_ptr<const Model> model);

  Answer CanReachGoal(Bits state, int64_t max_expansions);

 private:
  ExploredGraph graph_;
};

}  // namespace cell::planning
