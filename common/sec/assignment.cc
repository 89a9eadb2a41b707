#include "common/sec/assignment.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace cell {

std::span<const int> Assignment::Solve(std::span<const int> weights,
                                       size_t num_rows, size_t num_columns) {
  if (num_rows > num_columns) {
    transposed_.resize(weights.size());
    for (size_t i = 0; i < num_rows; ++i) {
      for (size_t j = 0; j < num_columns; ++j) {
        transposed_[j * num_rows + i] = weights[i * num_columns + j];
      }
    }
    const std::vector<int> by_columns = std::move(transposed_);
    const auto rows = Solve(by_columns, num_columns, num_rows);
    std::vector<int> columns(num_rows, kNone);
    for (size_t j = 0; j < num_columns; ++j) {
      columns[static_cast<size_t>(rows[j])] = static_cast<int>(j);
    }
    result_ = std::move(columns);
    return result_;
  }
  const Tables t = MakeTables(num_rows, num_columns);
  StartWithBest(weights, num_rows, num_columns, t);
  for (size_t row = 1; row <= num_rows; ++row) {
    if (result_[row - 1] == kNone) Augment(weights, row, num_columns, t);
  }
  for (size_t j = 1; j <= num_columns; ++j) {
    const int row = t.row_of[j];
    if (row > 0)
      result_[static_cast<size_t>(row - 1)] = static_cast<int>(j - 1);
  }
  return result_;
}

// All in one piece of memory: most problems are so small that to get memory
// would take longer than to solve them.
Assignment::Tables Assignment::MakeTables(size_t num_rows, size_t num_columns) {
  const size_t length = num_columns + 1;
  tables_.resize(num_rows + 1 + 5 * length);
  int* next = tables_.data();
  const auto table = [&](size_t size) {
    return std::exchange(next, next + size);
  };
  Tables t{};
  t.row_potential = table(num_rows + 1);
  t.column_potential = table(length);
  t.row_of = table(length);
  t.predecessor = table(length);
  t.slack = table(length);
  t.is_in_tree = table(length);
  std::fill_n(t.column_potential, 2 * length, 0);  // and row_of
  return t;
}

// Assigns rows to a best column of theirs as long as one is free. That is the
// best for these rows; the potentials say so.
void Assignment::StartWithBest(std::span<const int> weights, size_t num_rows,
                               size_t num_columns, const Tables& t) {
  result_.assign(num_rows, kNone);
  for (size_t i = 0; i < num_rows; ++i) {
    const int* row = weights.data() + i * num_columns;
    int best = row[0];
    for (size_t j = 1; j < num_columns; ++j) best = std::max(best, row[j]);
    t.row_potential[i + 1] = -best;
    for (size_t j = 0; j < num_columns; ++j) {
      if (row[j] != best || t.row_of[j + 1] != 0) continue;
      t.row_of[j + 1] = static_cast<int>(i + 1);
      result_[i] = static_cast<int>(j);
      break;
    }
  }
}

// Grows a tree of shortest alternating paths from `row` to a free column, with
// costs that are the negative weights, and turns the path over.
void Assignment::Augment(std::span<const int> weights, size_t row,
                         size_t num_columns, const Tables& t) {
  constexpr int kInfinite = std::numeric_limits<int>::max();
  std::fill_n(t.slack, num_columns + 1, kInfinite);
  std::fill_n(t.is_in_tree, num_columns + 1, 0);
  t.row_of[0] = static_cast<int>(row);
  size_t column = 0;
  do {
    t.is_in_tree[column] = 1;
    const auto i = static_cast<size_t>(t.row_of[column]);
    const int* row_weights = weights.data() + (i - 1) * num_columns;
    const int potential = t.row_potential[i];
    size_t nearest = 0;
    int step = kInfinite;
    for (size_t j = 1; j <= num_columns; ++j) {
      if (t.is_in_tree[j]) continue;
      const int reduced =
          -row_weights[j - 1] - potential - t.column_potential[j];
      if (reduced < t.slack[j]) {
        t.slack[j] = reduced;
        t.predecessor[j] = static_cast<int>(column);
      }
      if (t.slack[j] < step) {
        step = t.slack[j];
        nearest = j;
      }
    }
    for (size_t j = 0; step != 0 && j <= num_columns; ++j) {
      if (t.is_in_tree[j]) {
        t.row_potential[t.row_of[j]] += step;
        t.column_potential[j] -= step;
      } else {
        t.slack[j] -= step;
      }
    }
    column = nearest;
  } while (t.row_of[column] != 0);
  while (column != 0) {
    const auto before = static_cast<size_t>(t.predecessor[column]);
    t.row_of[column] = t.row_of[before];
    column = before;
  }
}

}  // namespace cell
