#include "common/sec/derivative_similarity.h"

#include <algorithm>
#include <vector>

#include "common/sec/assignment.h"
#include "common/sec/column_alignment.h"

namespace cell {
namespace {

// A row of a derivative chain: from and to in one number.
using Changes = std::vector<uint8_t>;

Changes DerivativeOf(std::span<const uint8_t> row) {
  const auto change = [](uint8_t from, uint8_t to) {
    return static_cast<uint8_t>(RelationMatrix::kNumSymbols * from + to);
  };
  if (row.size() == 1) return {change(row[0], row[0])};
  Changes derivative;
  for (size_t i = 1; i < row.size(); ++i) {
    derivative.push_back(change(row[i - 1], row[i]));
  }
  return derivative;
}

std::vector<Changes> DerivativesOf(const RelationMatrix& matrix) {
  std::vector<Changes> rows;
  for (size_t row = 0; row < matrix.num_rows(); ++row) {
    rows.push_back(DerivativeOf(matrix.Row(row)));
  }
  return rows;
}

Changes WithoutRests(Changes row) {
  std::erase_if(row, [](uint8_t change) {
    return change % (RelationMatrix::kNumSymbols + 1) == 0;
  });
  return row;
}

double SubstringShare(const Changes& a, const Changes& b) {
  if (a.size() > b.size()) return SubstringShare(b, a);
  if (b.empty()) return 1;
  ptrdiff_t best = 0;
  for (size_t shift = 0; shift <= b.size() - a.size(); ++shift) {
    ptrdiff_t num_equal = 0;
    for (size_t k = 0; k < a.size(); ++k) num_equal += a[k] == b[k + shift];
    best = std::max(best, num_equal);
  }
  return static_cast<double>(best) / static_cast<double>(b.size());
}

LinePairs CorrespondingRows(const std::vector<Changes>& a,
                            const std::vector<Changes>& b) {
  constexpr double kUnit = 1e6;  // of an integer weight
  std::vector<Changes> changes_b;
  for (const Changes& row : b) changes_b.push_back(WithoutRests(row));
  std::vector<int> weights;
  for (const Changes& row : a) {
    const Changes changes = WithoutRests(row);
    for (const Changes& other : changes_b) {
      weights.push_back(
          static_cast<int>(kUnit * SubstringShare(changes, other)));
    }
  }
  Assignment assignment;
  const auto row_of_b = assignment.Solve(weights, a.size(), b.size());
  LinePairs rows;
  for (size_t i = 0; i < row_of_b.size(); ++i) {
    if (row_of_b[i] == Assignment::kNone) continue;
    rows.emplace_back(i, static_cast<size_t>(row_of_b[i]));
  }
  return rows;
}

}  // namespace

double DerivativeSimilarity::OfSorted(const RelationMatrix& a,
                                      const RelationMatrix& b) const {
  const auto rows_a = DerivativesOf(a);
  const auto rows_b = DerivativesOf(b);
  const LinePairs rows = CorrespondingRows(rows_a, rows_b);
  const size_t num_a = rows_a.front().size();
  const size_t num_b = rows_b.front().size();
  std::vector<int> num_equal(num_a * num_b);
  for (const auto& [i, j] : rows) {
    for (size_t u = 0; u < num_a; ++u) {
      for (size_t v = 0; v < num_b; ++v) {
        num_equal[u * num_b + v] += rows_a[i][u] == rows_b[j][v];
      }
    }
  }
  ColumnAlignment columns;
  return columns.Solve(num_equal, num_a, num_b) /
         static_cast<double>(rows.size() * std::max(num_a, num_b));
}

}  // namespace cell
