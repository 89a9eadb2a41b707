#include "common/sec/entry_counts.h"

#include <algorithm>

namespace cell {
namespace {

constexpr size_t kWordBits = 64;
constexpr size_t kNarrow = 8;
constexpr size_t kWide = 16;

}  // namespace

EntryCounts::Places::Places(const RelationMatrix& b, bool is_by_rows,
                            size_t lane_bits) {
  const size_t num_lanes = kWordBits / lane_bits;
  const size_t num_lines = is_by_rows ? b.num_rows() : b.num_columns();
  const size_t length = is_by_rows ? b.num_columns() : b.num_rows();
  num_words_ = (length + num_lanes - 1) / num_lanes;
  words_.resize(num_lines * RelationMatrix::kNumSymbols * num_words_);
  for (size_t row = 0; row < b.num_rows(); ++row) {
    const auto symbols = b.Row(row);
    for (size_t column = 0; column < symbols.size(); ++column) {
      const size_t line = is_by_rows ? row : column;
      const size_t place = is_by_rows ? column : row;
      const size_t first =
          (line * RelationMatrix::kNumSymbols + symbols[column]) * num_words_;
      words_[first + place / num_lanes] |= uint64_t{1}
                                           << place % num_lanes * lane_bits;
    }
  }
}

EntryCounts::EntryCounts(const RelationMatrix& a, const RelationMatrix& b)
    : a_(a), b_(b) {}

// No count is greater than the number of pairs.
const EntryCounts::Lanes& EntryCounts::LanesFor(size_t num_pairs) {
  const bool is_narrow = num_pairs < size_t{1} << kNarrow;
  std::optional<Lanes>& lanes = is_narrow ? narrow_ : wide_;
  if (!lanes) lanes.emplace(b_, is_narrow ? kNarrow : kWide);
  return *lanes;
}

std::span<const int> EntryCounts::OfColumns(const LinePairs& rows) {
  const Lanes& lanes = LanesFor(rows.size());
  const size_t width = lanes.by_rows.num_words();
  sums_.assign(a_.num_columns() * width, 0);
  for (const auto& [i, j] : rows) {
    const uint64_t* places = lanes.by_rows.Of(j);
    uint64_t* sum = sums_.data();
    for (const uint8_t symbol : a_.Row(i)) {
      const uint64_t* place = places + symbol * width;
      for (size_t w = 0; w < width; ++w) *sum++ += place[w];
    }
  }
  return Unpack(a_.num_columns(), b_.num_columns(), width, lanes.bits);
}

std::span<const int> EntryCounts::OfRows(const LinePairs& columns) {
  const Lanes& lanes = LanesFor(columns.size());
  const size_t width = lanes.by_columns.num_words();
  sums_.assign(a_.num_rows() * width, 0);
  for (size_t i = 0; i < a_.num_rows(); ++i) {
    const uint8_t* row = a_.Row(i).data();
    uint64_t* sum = &sums_[i * width];
    for (const auto& [u, v] : columns) {
      const uint64_t* place = lanes.by_columns.Of(v) + row[u] * width;
      for (size_t w = 0; w < width; ++w) sum[w] += place[w];
    }
  }
  return Unpack(a_.num_rows(), b_.num_rows(), width, lanes.bits);
}

std::span<const int> EntryCounts::Unpack(size_t num_lines_a, size_t num_lines_b,
                                         size_t num_words, size_t lane_bits) {
  counts_.resize(num_lines_a * num_lines_b);
  const size_t num_lanes = kWordBits / lane_bits;
  const uint64_t lane = (uint64_t{1} << lane_bits) - 1;
  int* count = counts_.data();
  for (size_t i = 0; i < num_lines_a; ++i) {
    const uint64_t* words = &sums_[i * num_words];
    for (size_t j = 0; j < num_lines_b; j += num_lanes, ++words) {
      uint64_t word = *words;
      const size_t end = std::min(j + num_lanes, num_lines_b);
      for (size_t k = j; k < end; ++k, word >>= lane_bits) {
        *count++ = static_cast<int>(word & lane);
      }
    }
  }
  return counts_;
}

}  // namespace cell
