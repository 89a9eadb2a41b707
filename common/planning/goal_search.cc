#include "common/planning/goal_search.h"

#include <queue>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace cell::planning {

GoalSearch::GoalSearch(std::shared_ptr<const Model> model)
    : graph_(std::move(model)) {}

GoalSearch::Answer GoalSearch::CanReachGoal(Bits state,
                                            int64_t max_expansions) {
  using Entry = std::tuple<double, int, int>;  // distance, order, state
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::set<int> seen;
  const auto add = [&](int s) {
    if (graph_.max_probability(s) <= 0 || !seen.insert(s).second) return;
    open.emplace(graph_.distance(s), static_cast<int>(seen.size()), s);
  };
  add(graph_.Enter(state));
  for (int64_t i = 0; !open.empty(); ++i) {
    const int s = std::get<2>(open.top());
    open.pop();
    if (graph_.IsGoal(s)) return Answer::kYes;
    if (i == max_expansions) return Answer::kUndecided;
    if (!graph_.IsExpanded(s)) graph_.Expand(s);
    const int first = graph_.first_choice(s);
    for (int c = first; c < first + graph_.num_choices(s); ++c) {
      for (const auto& outcome : graph_.outcomes(graph_.choice(c))) {
        add(outcome.state);
      }
    }
  }
  return Answer::kNo;
}

}  // namespace cell::planning
