#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "common/planning/explored_graph.h"
#include "common/planning/probability_bounds.h"

namespace cell::planning {

/// When a search gives up.
struct Budget {
  int64_t max_expansions = 0;  ///< counted from the graph's beginning
  int64_t max_bytes = 0;
};

/// Asked between two passes of a search, when it can be saved; false stops it.
using MayGoOn = std::function<bool()>;

/// Narrows the bounds of the probability of reaching the goal from a state by
/// depth-first passes over the states that the choices of the highest upper
/// bounds lead to. Each pass expands what is not expanded, improves bounds on
/// its way back (Tarjan's algorithm gives the order), and collapses end
/// components where they have converged. Every other pass follows the choices
/// of the highest lower bounds, so that the policy that is sure of most comes
/// to know what to do when an outcome is not the hoped one.
class BoundSearch {
 public:
  BoundSearch(ExploredGraph* graph, ProbabilityBounds* bounds)
      : graph_(*graph), bounds_(*bounds) {}

  /// Returns true once the bounds of `state` are no further apart than
  /// `precision`; false if the budget is spent before, or if it is stopped.
  bool Solve(int state, double precision, const Budget& budget,
             const MayGoOn& may_go_on = {});

  /// Expands the state unless the budget is spent; returns whether it is
  /// expanded.
  bool TryExpand(int state, const Budget& budget);

  void Save(StateWriter* out) const;
  /// The next Solve() goes on with the one that was going on.
  /// @throws as StateReader does
  void Restore(StateReader* in);

 private:
  struct Frame {
    int block;
    int choice;
    int outcome;
    double reach;  ///< probability of the path that led here
  };
  struct MemoryCheck {
    int64_t next = 0;  ///< at so many expansions
    bool is_spent = false;
  };
  struct Mark {
    int64_t pass = 0;  ///< in which the others were set
    int number = 0;
    int low = 0;
    bool is_open = false;
  };

  /// Which bound's choices a pass follows.
  enum class Bound { kLower, kUpper };

  Mark& MarkOf(int block) { return marks_[static_cast<size_t>(block)]; }
  void Pass(int root, Bound bound);
  int Chosen(const ProbabilityBounds::Update& update) const;
  bool IsWorthEntering(int block, double reach);
  void Open(int block, double reach);
  /// Goes on with the next outcome of the last frame, or closes it.
  void Step();
  /// Chooses again after all outcomes were entered; false if nothing is left.
  bool ChooseAgain(Frame* frame);
  void Close();
  void Converge(std::vector<int> blocks);
  double Sweep(const std::vector<int>& blocks);
  bool IsSpent(const Budget& budget);

  ExploredGraph& graph_;
  ProbabilityBounds& bounds_;
  Budget budget_;
  double precision_ = 0;
  double cut_ = 0;
  bool is_restored_ = false;  // with the cut of a Solve() to go on with
  Bound followed_ = Bound::kUpper;
  bool has_changed_ = false;
  int64_t pass_ = 0;
  int num_numbered_ = 0;
  MemoryCheck memory_;
  std::vector<Frame> frames_;
  std::vector<int> stack_;
  std::vector<Mark> marks_;
  std::vector<int64_t> tried_in_;  // pass in which each choice was tried last
};

}  // namespace cell::planning
