#include "common/sec/layered_similarity.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <vector>

namespace cell {
namespace {

/// A chain whose rows are in the order of their matrix, sorted: the same for
/// any order of the rows, as far as touching tells them apart.
class SortedRows {
 public:
  SortedRows(const LayeredChain& chain, RoleTable* roles) : chain_(chain) {
    const RelationMatrix matrix(chain.touching, roles);
    order_.resize(matrix.num_rows());
    std::iota(order_.begin(), order_.end(), size_t{0});
    std::vector<size_t> columns(matrix.num_columns());
    std::iota(columns.begin(), columns.end(), size_t{0});
    std::ranges::sort(order_, [&](size_t i, size_t j) {
      if (matrix.role(i) != matrix.role(j)) {
        return matrix.role(i) < matrix.role(j);
      }
      return std::ranges::lexicographical_compare(Key(matrix, i),
                                                  Key(matrix, j));
    });
    matrix_ = matrix.Select(order_, columns);
  }

  const RelationMatrix& matrix() const { return matrix_; }
  Place PlaceAt(size_t row, size_t column) const {
    return chain_.places[order_[row]][column];
  }
  Motion MotionAt(size_t row, size_t column) const {
    return chain_.motions[order_[row]][column];
  }
  bool IsBefore(const SortedRows& other) const {
    if (matrix_ != other.matrix_) return matrix_ < other.matrix_;
    return AllKeys() < other.AllKeys();
  }

 private:
  std::vector<int> Key(const RelationMatrix& matrix, size_t row) const {
    std::vector<int> key;
    for (const uint8_t symbol : matrix.Row(row)) key.push_back(symbol);
    for (const Place place : chain_.places[row]) {
      key.push_back(static_cast<int>(place));
    }
    for (const Motion motion : chain_.motions[row]) {
      key.push_back(static_cast<int>(motion));
    }
    return key;
  }
  std::vector<std::vector<int>> AllKeys() const {
    std::vector<std::vector<int>> keys;
    const RelationMatrix none(std::vector<uint32_t>(order_.size()), 0);
    for (const size_t row : order_) keys.push_back(Key(none, row));
    return keys;
  }

  const LayeredChain& chain_;
  std::vector<size_t> order_;
  RelationMatrix matrix_;
};

}  // namespace

double LayeredSimilarity::Between(const LayeredChain& a,
                                  const LayeredChain& b) const {
  RoleTable roles(params_.types);
  // Numbered alike whichever chain comes first.
  std::set<ObjectPair> pairs(a.touching.pairs().begin(),
                             a.touching.pairs().end());
  pairs.insert(b.touching.pairs().begin(), b.touching.pairs().end());
  for (const ObjectPair& pair : pairs) roles.RoleOf(pair);
  const SortedRows rows_a(a, &roles), rows_b(b, &roles);
  if (rows_a.matrix().is_empty() || rows_b.matrix().is_empty()) {
    return rows_a.matrix().is_empty() == rows_b.matrix().is_empty();
  }
  const bool is_swapped = rows_b.IsBefore(rows_a);
  const SortedRows& first = is_swapped ? rows_b : rows_a;
  const SortedRows& second = is_swapped ? rows_a : rows_b;
  const ChainAlignment alignment =
      AlignChains(first.matrix(), second.matrix(), params_.roles);
  int num_equal = alignment.num_equal;
  for (const auto& [i, j] : alignment.rows) {
    for (const auto& [u, v] : alignment.columns) {
      num_equal +=
          params_.has_places && first.PlaceAt(i, u) == second.PlaceAt(j, v);
      num_equal +=
          params_.has_motions && first.MotionAt(i, u) == second.MotionAt(j, v);
    }
  }
  const int num_layers = 1 + params_.has_places + params_.has_motions;
  return 2.0 * num_equal /
         static_cast<double>(
             static_cast<size_t>(num_layers) *
             (rows_a.matrix().num_entries() + rows_b.matrix().num_entries()));
}

}  // namespace cell
