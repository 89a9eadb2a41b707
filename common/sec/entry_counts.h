#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "common/sec/relation_matrix.h"

namespace cell {

/// Lines (rows or columns) of two matrices that correspond, in order.
using LinePairs = std::vector<std::pair<size_t, size_t>>;

/// Counts equal entries of two matrices: of each pair of columns over rows that
/// correspond, and of each pair of rows over columns that correspond. Counts of
/// several lines are kept side by side in one word of 64 bits.
///
/// `a` and `b` must outlive this object.
class EntryCounts {
 public:
  EntryCounts(const RelationMatrix& a, const RelationMatrix& b);

  /// Equal entries of column u of `a` and v of `b` at u * b.num_columns() + v.
  /// Valid until the next call.
  std::span<const int> OfColumns(const LinePairs& rows);
  /// Equal entries of row i of `a` and j of `b` at i * b.num_rows() + j.
  std::span<const int> OfRows(const LinePairs& columns);

 private:
  // Of each line and symbol of `b`: where the symbol is, a count of 1 there.
  struct Places {
    size_t num_words = 0;
    std::vector<uint64_t> words;
  };
  static Places PlacesOf(const RelationMatrix& b, bool is_by_rows);
  std::span<const int> Unpack(size_t num_lines_a, size_t num_lines_b,
                              size_t num_words);

  const RelationMatrix& a_;
  const RelationMatrix& b_;
  Places by_rows_, by_columns_;
  std::vector<uint64_t> sums_;
  std::vector<int> counts_;
};

}  // namespace cell
