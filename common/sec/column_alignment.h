#pragma once

#include <span>
#include <vector>

#include "common/sec/entry_counts.h"

namespace cell {

/// Pairs lines of two sequences in their order so that the sum of the gains of
/// the pairs is largest, by dynamic programming. Keeps its buffers.
///
/// Cost: the product of the numbers of lines.
class ColumnAlignment {
 public:
  /// The largest sum. `gains` (>= 0) of line u and v are at u * num_b + v.
  int Solve(std::span<const int> gains, size_t num_a, size_t num_b);
  /// The pairs of the last call of Solve() that gain something, in order. Of
  /// several best alignments always the same.
  LinePairs Pairs() const {
    LinePairs pairs;
    PutPairs(&pairs);
    return pairs;
  }
  /// The same, in place of what `pairs` had.
  void PutPairs(LinePairs* pairs) const;

 private:
  int Best(size_t num_of_a, size_t num_of_b) const {
    return best_[num_of_a * (num_b_ + 1) + num_of_b];
  }

  std::span<const int> gains_;
  size_t num_a_ = 0, num_b_ = 0;
  std::vector<int> best_;  // sum for the first so many of each
};

}  // namespace cell
