#include "common/sec/column_alignment.h"

#include <algorithm>

namespace cell {

int ColumnAlignment::Solve(std::span<const int> gains, size_t num_a,
                           size_t num_b) {
  gains_ = gains;
  num_a_ = num_a;
  num_b_ = num_b;
  best_.assign((num_a + 1) * (num_b + 1), 0);
  for (size_t u = 0; u < num_a; ++u) {
    const int* above = &best_[u * (num_b + 1)];
    int* row = &best_[(u + 1) * (num_b + 1)];
    for (size_t v = 0; v < num_b; ++v) {
      row[v + 1] =
          std::max({above[v] + gains[u * num_b + v], above[v + 1], row[v]});
    }
  }
  return best_.back();
}

void ColumnAlignment::PutPairs(LinePairs* pairs) const {
  pairs->clear();
  pairs->reserve(std::min(num_a_, num_b_));
  size_t u = num_a_;
  size_t v = num_b_;
  while (u > 0 && v > 0) {
    const int best = Best(u, v);
    if (best == Best(u - 1, v)) {
      --u;
    } else if (best == Best(u, v - 1)) {
      --v;
    } else {
      pairs->emplace_back(--u, --v);
    }
  }
  std::ranges::reverse(*pairs);
}

}  // namespace cell
