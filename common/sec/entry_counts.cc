#include "common/sec/entry_counts.h"

namespace cell {
namespace {

constexpr size_t kLanes = 4;  // counts of 16 bits in a word
constexpr size_t kLaneBits = 16;

}  // namespace

EntryCounts::EntryCounts(const RelationMatrix& a, const RelationMatrix& b)
    : a_(a),
      b_(b),
      by_rows_(PlacesOf(b, true)),
      by_columns_(PlacesOf(b, false)) {}

EntryCounts::Places EntryCounts::PlacesOf(const RelationMatrix& b,
                                          bool is_by_rows) {
  const size_t num_lines = is_by_rows ? b.num_rows() : b.num_columns();
  const size_t length = is_by_rows ? b.num_columns() : b.num_rows();
  Places places;
  places.num_words = (length + kLanes - 1) / kLanes;
  places.words.resize(num_lines * RelationMatrix::kNumSymbols *
                      places.num_words);
  for (size_t row = 0; row < b.num_rows(); ++row) {
    for (size_t column = 0; column < b.num_columns(); ++column) {
      const size_t line = is_by_rows ? row : column;
      const size_t place = is_by_rows ? column : row;
      const size_t first =
          (line * RelationMatrix::kNumSymbols + b.Symbol(row, column)) *
          places.num_words;
      places.words[first + place / kLanes] |= uint64_t{1}
                                              << place % kLanes * kLaneBits;
    }
  }
  return places;
}

std::span<const int> EntryCounts::OfColumns(const LinePairs& rows) {
  const size_t width = by_rows_.num_words;
  sums_.assign(a_.num_columns() * width, 0);
  for (const auto& [i, j] : rows) {
    const auto row = a_.Row(i);
    const uint64_t* places =
        &by_rows_.words[j * RelationMatrix::kNumSymbols * width];
    for (size_t u = 0; u < row.size(); ++u) {
      for (size_t w = 0; w < width; ++w) {
        sums_[u * width + w] += places[row[u] * width + w];
      }
    }
  }
  return Unpack(a_.num_columns(), b_.num_columns(), width);
}

std::span<const int> EntryCounts::OfRows(const LinePairs& columns) {
  const size_t width = by_columns_.num_words;
  sums_.assign(a_.num_rows() * width, 0);
  for (size_t i = 0; i < a_.num_rows(); ++i) {
    for (const auto& [u, v] : columns) {
      const uint64_t* places =
          &by_columns_
               .words[(v * RelationMatrix::kNumSymbols + a_.Symbol(i, u)) *
                      width];
      for (size_t w = 0; w < width; ++w) sums_[i * width + w] += places[w];
    }
  }
  return Unpack(a_.num_rows(), b_.num_rows(), width);
}

std::span<const int> EntryCounts::Unpack(size_t num_lines_a, size_t num_lines_b,
                                         size_t num_words) {
  counts_.resize(num_lines_a * num_lines_b);
  constexpr uint64_t kLane = (uint64_t{1} << kLaneBits) - 1;
  for (size_t i = 0; i < num_lines_a; ++i) {
    for (size_t j = 0; j < num_lines_b; ++j) {
      const uint64_t word = sums_[i * num_words + j / kLanes];
      counts_[i * num_lines_b + j] =
          static_cast<int>(word >> j % kLanes * kLaneBits & kLane);
    }
  }
  return counts_;
}

}  // namespace cell
