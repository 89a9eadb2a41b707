#pragma once

#include <cstdint>
#include <vector>

#include "common/planning/explored_graph.h"

namespace cell::planning {

/// Lower and upper bounds of the highest probability of reaching the goal, for
/// the states of an explored graph. States of an end component are collapsed
/// into one block: from each of them every other one is reached with certainty,
/// so they share one value, and the choices that stay inside no longer count.
/// Without this the upper bound would be caught there.
class ProbabilityBounds {
 public:
  explicit ProbabilityBounds(const ExploredGraph* graph) : graph_(*graph) {}

  /// Gives bounds to the states that the graph has gained.
  void Extend();

  /// The state that stands for the block of a state.
  int BlockOf(int state);
  double low(int state) { return low_[Index(BlockOf(state))]; }
  double high(int state) { return high_[Index(BlockOf(state))]; }
  double width(int state) { return high(state) - low(state); }

  struct Value {
    double low = 0;
    double high = 0;
    double distance = 0;  ///< to be expected, for ties
    bool leaves = false;  ///< the block; if not, the choice does not count
  };
  /// Of a choice, taken until it leaves the block.
  Value Of(const ExploredGraph::Choice& choice);

  struct Update {
    int choice = -1;  ///< that has the highest upper bound; -1: none leaves
    int safe_choice = -1;  ///< that has the highest lower bound
    double change = 0;     ///< the larger one of both bounds'
    double drop = 0;       ///< of the upper bound
  };
  /// Improves the bounds of an expanded block by those of its successors.
  Update Improve(int block);

  /// Makes one block of the end components among the blocks, whose choices then
  /// no longer count. Returns whether there was one.
  bool CollapseEndComponents(const std::vector<int>& blocks);

  /// Calls visit(index) for every choice of the block.
  template <class Visit>
  void ForEachChoice(int block, Visit visit) const {
    const int members = members_of_[Index(block)];
    if (members >= 0) {
      for (const int c : choices_of_[Index(members)]) visit(c);
      return;
    }
    const int first = graph_.first_choice(block);
    for (int i = 0; i < graph_.num_choices(block); ++i) visit(first + i);
  }

  int64_t num_bytes() const;

  void Save(StateWriter* out) const;
  /// @throws as StateReader does
  void Restore(StateReader* in);

 private:
  static size_t Index(int i) { return static_cast<size_t>(i); }
  void Merge(const std::vector<int>& blocks);

  const ExploredGraph& graph_;
  std::vector<double> low_;
  std::vector<double> high_;
  std::vector<int> parent_;      // union-find
  std::vector<int> members_of_;  // index in choices_of_, or -1: the state's own
  std::vector<std::vector<int>> choices_of_;
};

}  // namespace cell::planning
