#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/sec/relation_matrix.h"

namespace cell {

/// Lengths of the longest common subsequences of one row with others, for which
/// it keeps the positions of each symbol as bits (Hyyro's bit-parallel method).
///
/// Cost per row: its length times the words of 64 columns of the first.
class RowSubsequence {
 public:
  explicit RowSubsequence(std::span<const uint8_t> row);

  int LengthWith(std::span<const uint8_t> other) const;

 private:
  using Positions = std::array<uint64_t, RelationMatrix::kNumSymbols>;

  int LengthInOneWord(std::span<const uint8_t> other) const;

  size_t length_;
  Positions first_positions_{};           // of each symbol in 64 columns
  std::vector<Positions> all_positions_;  // if there are more
};

}  // namespace cell
