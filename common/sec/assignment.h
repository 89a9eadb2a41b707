#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cell {

/// Assigns rows to columns so that the sum of the weights is largest, by the
/// Hungarian method with potentials (Kuhn and Munkres). Keeps its buffers from
/// one problem to the next.
///
/// Cost: rows * columns, and as much again for each row whose best columns
/// other rows have taken, at most min(rows, columns) times.
class Assignment {
 public:
  static constexpr int kNone = -1;

  /// `weights` are given by rows. Returns the column of each row. With more
  /// rows than columns some rows have kNone; with fewer some columns are free.
  /// Equal inputs give equal results, of several best ones always the same.
  std::span<const int> Solve(std::span<const int> weights, size_t num_rows,
                             size_t num_columns);

 private:
  // The method's tables of a problem, with index 0 for none: potentials of rows
  // and columns, row of each column, and of the current tree: slack,
  // predecessor, is in it.
  struct Tables {
    int* row_potential;
    int* column_potential;
    int* row_of;
    int* predecessor;
    int* slack;
    int* is_in_tree;
  };

  Tables MakeTables(size_t num_rows, size_t num_columns);
  void StartWithBest(std::span<const int> weights, size_t num_rows,
                     size_t num_columns, const Tables& t);
  static void Augment(std::span<const int> weights, size_t row,
                      size_t num_columns, const Tables& t);

  std::vector<int> result_;
  std::vector<int> transposed_;
  std::vector<int> tables_;
};

}  // namespace cell
