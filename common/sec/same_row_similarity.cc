#include "common/sec/same_row_similarity.h"

#include <algorithm>

namespace cell {
namespace {

auto Distinct(const EventChain& chain, size_t row) {
  auto entries = chain.Row(row);
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  return entries;
}

}  // namespace

double SameRowSimilarity::Between(const EventChain& a,
                                  const EventChain& b) const {
  size_t num_common = 0;
  size_t num_equal = 0;
  for (size_t row = 0; row < a.num_rows(); ++row) {
    const auto other = b.FindRow(a.pairs()[row]);
    if (!other) continue;
    ++num_common;
    if (Distinct(a, row) == Distinct(b, *other)) ++num_equal;
  }
  const size_t num_rows = a.num_rows() + b.num_rows() - num_common;
  if (num_rows == 0) return a.num_columns() == b.num_columns() ? 1 : 0;
  return static_cast<double>(num_equal) / static_cast<double>(num_rows);
}

}  // namespace cell
