#include "common/sec/paper_similarity.h"

#include <algorithm>

#include "common/sec/assignment.h"
#include "common/sec/chain_alignment.h"
#include "common/sec/column_alignment.h"

namespace cell {

// All rows of a matrix are of one length, so the lengths of the common
// subsequences are as good as their ratios.
double PaperSimilarity::OfSorted(const RelationMatrix& a,
                                 const RelationMatrix& b) const {
  Assignment assignment;
  const auto row_of_b =
      assignment.Solve(CommonLengths(a, b), a.num_rows(), b.num_rows());
  LinePairs rows;
  for (size_t i = 0; i < row_of_b.size(); ++i) {
    if (row_of_b[i] == Assignment::kNone) continue;
    rows.emplace_back(i, static_cast<size_t>(row_of_b[i]));
  }
  EntryCounts counts(a, b);
  ColumnAlignment columns;
  const int num_equal =
      columns.Solve(counts.OfColumns(rows), a.num_columns(), b.num_columns());
  const size_t num_columns = std::max(a.num_columns(), b.num_columns());
  return num_equal / static_cast<double>(rows.size() * num_columns);
}

}  // namespace cell
