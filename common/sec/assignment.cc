#include "common/sec/assignment.h"

#include <algorithm>
#include <limits>

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
  StartWithBest(weights, num_rows, num_columns);
  for (size_t row = 1; row <= num_rows; ++row) {
    if (result_[row - 1] == kNone) Augment(weights, row, num_columns);
  }
  for (size_t j = 1; j <= num_columns; ++j) {
    if (row_of_[j] > 0) result_[row_of_[j] - 1] = static_cast<int>(j - 1);
  }
  return result_;
}

// Assigns rows to a best column of theirs as long as one is free. That is the
// best for these rows; the potentials say so.
void Assignment::StartWithBest(std::span<const int> weights, size_t num_rows,
                               size_t num_columns) {
  result_.assign(num_rows, kNone);
  row_potential_.resize(num_rows + 1);
  column_potential_.assign(num_columns + 1, 0);
  row_of_.assign(num_columns + 1, 0);
  predecessor_.resize(num_columns + 1);
  for (size_t i = 0; i < num_rows; ++i) {
    const auto row = weights.subspan(i * num_columns, num_columns);
    const int best = *std::ranges::max_element(row);
    row_potential_[i + 1] = -best;
    for (size_t j = 0; j < num_columns; ++j) {
      if (row[j] != best || row_of_[j + 1] != 0) continue;
      row_of_[j + 1] = i + 1;
      result_[i] = static_cast<int>(j);
      break;
    }
  }
}

// Grows a tree of shortest alternating paths from `row` to a free column, with
// costs that are the negative weights, and turns the path over.
void Assignment::Augment(std::span<const int> weights, size_t row,
                         size_t num_columns) {
  constexpr int kInfinite = std::numeric_limits<int>::max();
  slack_.assign(num_columns + 1, kInfinite);
  is_in_tree_.assign(num_columns + 1, 0);
  row_of_[0] = row;
  size_t column = 0;
  do {
    is_in_tree_[column] = 1;
    const size_t i = row_of_[column];
    const int* row_weights = weights.data() + (i - 1) * num_columns;
    size_t nearest = 0;
    int step = kInfinite;
    for (size_t j = 1; j <= num_columns; ++j) {
      if (is_in_tree_[j]) continue;
      const int reduced =
          -row_weights[j - 1] - row_potential_[i] - column_potential_[j];
      if (reduced < slack_[j]) {
        slack_[j] = reduced;
        predecessor_[j] = column;
      }
      if (slack_[j] < step) {
        step = slack_[j];
        nearest = j;
      }
    }
    for (size_t j = 0; j <= num_columns; ++j) {
      if (is_in_tree_[j]) {
        row_potential_[row_of_[j]] += step;
        column_potential_[j] -= step;
      } else {
        slack_[j] -= step;
      }
    }
    column = nearest;
  } while (row_of_[column] != 0);
  while (column != 0) {
    row_of_[column] = row_of_[predecessor_[column]];
    column = predecessor_[column];
  }
}

}  // namespace cell
