#include "common/sec/row_subsequence.h"

#include <bit>

namespace cell {
namespace {

constexpr size_t kBits = 64;

}  // namespace

RowSubsequence::RowSubsequence(std::span<const uint8_t> row)
    : length_(row.size()) {
  if (length_ > kBits) all_positions_.resize((length_ + kBits - 1) / kBits);
  for (size_t i = 0; i < length_; ++i) {
    const uint64_t bit = uint64_t{1} << i % kBits;
    if (i < kBits) first_positions_[row[i]] |= bit;
    if (length_ > kBits) all_positions_[i / kBits][row[i]] |= bit;
  }
}

int RowSubsequence::LengthInOneWord(std::span<const uint8_t> other) const {
  uint64_t ends = ~uint64_t{0};
  for (const uint8_t symbol : other) {
    const uint64_t common = ends & first_positions_[symbol];
    ends = (ends + common) | (ends - common);
  }
  if (length_ < kBits) ends |= ~uint64_t{0} << length_;
  return std::popcount(~ends);
}

// A zero bit of `ends` is a position at which the length grows by one.
int RowSubsequence::LengthWith(std::span<const uint8_t> other) const {
  if (all_positions_.empty()) return LengthInOneWord(other);
  std::vector<uint64_t> ends(all_positions_.size(), ~uint64_t{0});
  for (const uint8_t symbol : other) {
    uint64_t carry = 0;
    for (size_t w = 0; w < ends.size(); ++w) {
      const uint64_t common = ends[w] & all_positions_[w][symbol];
      const uint64_t sum = ends[w] + common;
      const uint64_t sum_carry = sum + carry;
      carry = static_cast<uint64_t>(sum < common || sum_carry < carry);
      ends[w] = sum_carry | (ends[w] - common);
    }
  }
  int length = 0;
  for (size_t i = 0; i < length_; ++i) {
    length += (ends[i / kBits] >> i % kBits & 1) == 0;
  }
  return length;
}

}  // namespace cell
