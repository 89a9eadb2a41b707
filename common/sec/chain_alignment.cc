#include "common/sec/chain_alignment.h"

#include <algorithm>
#include <cstdlib>

#include "common/sec/assignment.h"
#include "common/sec/column_alignment.h"
#include "common/sec/row_subsequence.h"

namespace cell {
namespace {

class Aligner {
 public:
  Aligner(const RelationMatrix& a, const RelationMatrix& b, RowRoles roles)
      : a_(a), b_(b), roles_(roles), counts_(a, b) {}

  ChainAlignment Solve() {
    ChainAlignment by_rows = ImproveFrom(AssignRows(CommonLengths(a_, b_)));
    ChainAlignment by_columns =
        ImproveFrom(AssignRows(counts_.OfRows(NearDiagonal())));
    return by_columns.num_equal > by_rows.num_equal ? std::move(by_columns)
                                                    : std::move(by_rows);
  }

 private:
  ChainAlignment ImproveFrom(LinePairs rows) {
    ChainAlignment best;
    while (true) {
      const int num_equal = columns_.Solve(counts_.OfColumns(rows),
                                           a_.num_columns(), b_.num_columns());
      if (num_equal <= best.num_equal) break;
      best = {std::move(rows), columns_.Pairs(), num_equal};
      rows = AssignRows(counts_.OfRows(best.columns));
    }
    return best;
  }

  // Columns that may correspond if the shorter chain's are all there, the more
  // often the nearer they are to the straight line through both.
  LinePairs NearDiagonal() const {
    const auto last_a = static_cast<ptrdiff_t>(a_.num_columns()) - 1;
    const auto last_b = static_cast<ptrdiff_t>(b_.num_columns()) - 1;
    LinePairs pairs;
    for (ptrdiff_t u = 0; u <= last_a; ++u) {
      const ptrdiff_t surplus = last_b - last_a;
      for (ptrdiff_t v = u + std::min<ptrdiff_t>(surplus, 0);
           v <= u + std::max<ptrdiff_t>(surplus, 0); ++v) {
        if (v < 0 || v > last_b) continue;
        const ptrdiff_t distance = std::abs(v * last_a - u * last_b);
        const int weight = 1 + (distance < last_a) + (2 * distance < last_a);
        pairs.insert(pairs.end(), static_cast<size_t>(weight), {u, v});
      }
    }
    return pairs;
  }

  bool MayCorrespond(size_t row_a, size_t row_b) const {
    return roles_ == RowRoles::kIgnored || a_.role(row_a) == b_.role(row_b);
  }

  LinePairs AssignRows(std::span<const int> lengths) {
    weights_.assign(lengths.begin(), lengths.end());
    for (size_t k = 0; k < weights_.size(); ++k) {
      if (!MayCorrespond(k / b_.num_rows(), k % b_.num_rows())) weights_[k] = 0;
    }
    const auto columns =
        assignment_.Solve(weights_, a_.num_rows(), b_.num_rows());
    LinePairs rows;
    for (size_t i = 0; i < columns.size(); ++i) {
      const auto j = static_cast<size_t>(columns[i]);
      if (columns[i] != Assignment::kNone && MayCorrespond(i, j)) {
        rows.emplace_back(i, j);
      }
    }
    return rows;
  }

  const RelationMatrix& a_;
  const RelationMatrix& b_;
  RowRoles roles_;
  EntryCounts counts_;
  Assignment assignment_;
  ColumnAlignment columns_;
  std::vector<int> weights_;
};

}  // namespace

std::vector<int> CommonLengths(const RelationMatrix& a,
                               const RelationMatrix& b) {
  std::vector<int> lengths;
  lengths.reserve(a.num_rows() * b.num_rows());
  for (size_t i = 0; i < a.num_rows(); ++i) {
    const RowSubsequence row(a.Row(i));
    for (size_t j = 0; j < b.num_rows(); ++j) {
      lengths.push_back(row.LengthWith(b.Row(j)));
    }
  }
  return lengths;
}

ChainAlignment AlignChains(const RelationMatrix& a, const RelationMatrix& b,
                           RowRoles roles) {
  if (a.is_empty() || b.is_empty()) return {};
  return Aligner(a, b, roles).Solve();
}

double DiceOf(const ChainAlignment& alignment, const RelationMatrix& a,
              const RelationMatrix& b) {
  return 2.0 * alignment.num_equal /
         static_cast<double>(a.num_entries() + b.num_entries());
}

}  // namespace cell
