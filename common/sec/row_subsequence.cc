#include "common/sec/row_subsequence.h"

#include <bit>

namespace cell {

namespace {
constexpr size_t kBits = 64;
}  // namespace

RowSubsequence::RowSubsequence(std::span<const uint8_t> row)
    : length_(row.size()),
      num_words_((row.size() + kBits - 1) / kBits),
      positions_(num_words_ * RelationMatrix::kNumSymbols) {
  for (size_t i = 0; i < row.size(); ++i) {
    positions_[row[i] * num_words_ + i / kBits] |= uint64_t{1} << i % kBits;
  }
}

int RowSubsequence::LengthInOneWord(std::span<const uint8_t> other) const {
  uint64_t ends = ~uint64_t{0};
  for (const uint8_t symbol : other) {
    const uint64_t common = ends & positions_[symbol];
    ends = (ends + common) | (ends - common);
  }
  if (length_ < kBits) ends |= ~uint64_t{0} << length_;
  return std::popcount(~ends);
}

// A zero bit of `ends` is a position at which the length grows by one.
int RowSubsequence::LengthWith(std::span<const uint8_t> other) const {
  if (num_words_ == 1) return LengthInOneWord(other);
  std::vector<uint64_t> ends(num_words_, ~uint64_t{0});
  for (const uint8_t symbol : other) {
    uint64_t carry = 0;
    for (size_t w = 0; w < num_words_; ++w) {
      const uint64_t common = ends[w] & positions_[symbol * num_words_ + w];
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
