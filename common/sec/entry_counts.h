#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "common/sec/relation_matrix.h"

namespace cell {

/// Lines (rows or columns) of two matrices that correspond, in order.
using LinePairs = std::vector<std::pair<size_t, size_t>>;

/// Counts equal entries of two matrices: of each pair of columns over rows that
/// correspond, and of each pair of rows over columns that correspond. Counts of
/// several lines are kept side by side in one word of 64 bits: eight of them
/// while they are of fewer than 256 pairs, or else four.
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
  /// Of each line and symbol of `b`: where the symbol is, a count of 1 there.
  class Places {
   public:
    Places(const RelationMatrix& b, bool is_by_rows, size_t lane_bits);
    /// Of a line and symbol 0; the others follow, num_words() further each.
    const uint64_t* Of(size_t line) const {
      return &words_[line * RelationMatrix::kNumSymbols * num_words_];
    }
    size_t num_words() const { return num_words_; }

   private:
    size_t num_words_;
    std::vector<uint64_t> words_;
  };
  /// For counts of few pairs, or for many.
  struct Lanes {
    Lanes(const RelationMatrix& b, size_t lane_bits)
        : bits(lane_bits),
          by_rows(b, true, lane_bits),
          by_columns(b, false, lane_bits) {}

    size_t bits;
    Places by_rows, by_columns;
  };

  const Lanes& LanesFor(size_t num_pairs);
  std::span<const int> Unpack(size_t num_lines_a, size_t num_lines_b,
                              size_t num_words, size_t lane_bits);

  const RelationMatrix& a_;
  const RelationMatrix& b_;
  std::optional<Lanes> narrow_, wide_;  // as they are asked for
  std::vector<uint64_t> sums_;
  std::vector<int> counts_;
};

}  // namespace cell
