#include "common/sec/same_pair_similarity.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace cell {
namespace {

using RowPairs = std::vector<std::pair<size_t, size_t>>;

RowPairs CommonRows(const EventChain& a, const EventChain& b) {
  RowPairs rows;
  for (size_t row = 0; row < a.num_rows(); ++row) {
    if (const auto other = b.FindRow(a.pairs()[row])) {
      rows.emplace_back(row, *other);
    }
  }
  return rows;
}

}  // namespace

double SamePairSimilarity::Between(const EventChain& a,
                                   const EventChain& b) const {
  const RowPairs common = CommonRows(a, b);
  const size_t num_rows = a.num_rows() + b.num_rows() - common.size();
  const size_t num_columns = std::max(a.num_columns(), b.num_columns());
  if (num_rows == 0 || num_columns == 0) {
    return a.num_columns() == b.num_columns() ? 1 : 0;
  }
  const auto num_equal = [&](size_t column_a, size_t column_b) {
    return std::count_if(common.begin(), common.end(), [&](const auto& rows) {
      return a.At(rows.first, column_a) == b.At(rows.second, column_b);
    });
  };
  // best[j]: equal entries of the columns of `a` so far and the first j of `b`
  std::vector<std::ptrdiff_t> best(b.num_columns() + 1, 0);
  for (size_t i = 0; i < a.num_columns(); ++i) {
    std::ptrdiff_t diagonal = 0;
    for (size_t j = 0; j < b.num_columns(); ++j) {
      const std::ptrdiff_t aligned = diagonal + num_equal(i, j);
      diagonal = best[j + 1];
      best[j + 1] = std::max({aligned, best[j], best[j + 1]});
    }
  }
  return static_cast<double>(best.back()) /
         static_cast<double>(num_rows * num_columns);
}

}  // namespace cell
