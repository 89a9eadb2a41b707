#include "common/sec/chain_alignment.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "common/sec/assignment.h"
#include "common/sec/column_alignment.h"
#include "common/sec/row_subsequence.h"

namespace cell {
namespace {

constexpr ptrdiff_t kMostPlaces = 1 << 14;

// Rows of one role in both chains.
struct RoleGroup {
  std::vector<size_t> rows_a, rows_b;
};

std::vector<size_t> RowsByRole(const RelationMatrix& matrix) {
  std::vector<size_t> rows(matrix.num_rows());
  std::iota(rows.begin(), rows.end(), size_t{0});
  if (std::ranges::is_sorted(matrix.roles())) return rows;
  std::ranges::stable_sort(rows, {},
                           [&](size_t row) { return matrix.role(row); });
  return rows;
}

std::vector<RoleGroup> GroupsOf(const RelationMatrix& a,
                                const RelationMatrix& b, RowRoles roles) {
  const auto rows_a = RowsByRole(a);
  const auto rows_b = RowsByRole(b);
  if (roles == RowRoles::kIgnored) return {{rows_a, rows_b}};
  std::vector<RoleGroup> groups;
  size_t j = 0;
  for (size_t i = 0; i < rows_a.size();) {
    const uint32_t role = a.role(rows_a[i]);
    while (j < rows_b.size() && b.role(rows_b[j]) < role) ++j;
    RoleGroup group;
    while (i < rows_a.size() && a.role(rows_a[i]) == role) {
      group.rows_a.push_back(rows_a[i++]);
    }
    while (j < rows_b.size() && b.role(rows_b[j]) == role) {
      group.rows_b.push_back(rows_b[j++]);
    }
    if (!group.rows_b.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

class Aligner {
 public:
  Aligner(const RelationMatrix& a, const RelationMatrix& b, RowRoles roles)
      : a_(a),
        b_(b),
        groups_(GroupsOf(a, b, roles)),
        has_all_in_order_(roles == RowRoles::kIgnored &&
                          std::ranges::is_sorted(groups_[0].rows_a) &&
                          std::ranges::is_sorted(groups_[0].rows_b)),
        counts_(a, b) {}

  ChainAlignment Solve() {
    LinePairs by_length, by_place;
    AssignRows(CommonLengthsInGroups(), &by_length);
    AssignRows(counts_.OfRows(NearDiagonal()), &by_place);
    const bool is_one_start = by_place == by_length;
    ChainAlignment best = ImproveFrom(std::move(by_length));
    if (is_one_start || by_place == best.rows) return best;
    ChainAlignment other = ImproveFrom(std::move(by_place));
    return other.num_equal > best.num_equal ? other : best;
  }

 private:
  ChainAlignment ImproveFrom(LinePairs rows) {
    ChainAlignment best;
    while (rows != best.rows) {
      const int num_equal = columns_.Solve(counts_.OfColumns(rows),
                                           a_.num_columns(), b_.num_columns());
      if (num_equal <= best.num_equal) break;
      best.num_equal = num_equal;
      std::swap(best.rows, rows);
      columns_.PutPairs(&best.columns);
      AssignRows(counts_.OfRows(best.columns), &rows);
    }
    return best;
  }

  std::span<const int> CommonLengthsInGroups() {
    lengths_.assign(a_.num_rows() * b_.num_rows(), 0);
    for (const RoleGroup& group : groups_) {
      for (const size_t i : group.rows_a) {
        const RowSubsequence row(a_.Row(i));
        for (const size_t j : group.rows_b) {
          lengths_[i * b_.num_rows() + j] = row.LengthWith(b_.Row(j));
        }
      }
    }
    return lengths_;
  }

  // Columns that may correspond if the shorter chain's are all there, the more
  // often the nearer they are to the straight line through both.
  LinePairs NearDiagonal() const {
    const auto last_a = static_cast<ptrdiff_t>(a_.num_columns()) - 1;
    const auto last_b = static_cast<ptrdiff_t>(b_.num_columns()) - 1;
    const ptrdiff_t surplus = last_b - last_a;
    // EntryCounts has 16 bits: of many columns only the nearest.
    const bool has_far = (last_a + 1) * (std::abs(surplus) + 1) <= kMostPlaces;
    LinePairs pairs;
    for (ptrdiff_t u = 0; u <= last_a; ++u) {
      const ptrdiff_t first =
          std::max<ptrdiff_t>(u + std::min<ptrdiff_t>(surplus, 0), 0);
      const ptrdiff_t last =
          std::min(u + std::max<ptrdiff_t>(surplus, 0), last_b);
      for (ptrdiff_t v = first; v <= last; ++v) {
        const ptrdiff_t distance = std::abs(v * last_a - u * last_b);
        const int weight = surplus == 0 ? 1
                                        : has_far + (distance < last_a) +
                                              (2 * distance < last_a);
        pairs.insert(pairs.end(), static_cast<size_t>(weight),
                     {static_cast<size_t>(u), static_cast<size_t>(v)});
      }
    }
    return pairs;
  }

  // Puts the rows of each role that correspond, with weights as EntryCounts
  // has.
  void AssignRows(std::span<const int> weights, LinePairs* rows) {
    rows->clear();
    rows->reserve(std::min(a_.num_rows(), b_.num_rows()));
    for (const auto& [rows_a, rows_b] : groups_) {
      const auto row_of_b = assignment_.Solve(
          WeightsOf(weights, rows_a, rows_b), rows_a.size(), rows_b.size());
      for (size_t k = 0; k < row_of_b.size(); ++k) {
        if (row_of_b[k] == Assignment::kNone) continue;
        rows->emplace_back(rows_a[k], rows_b[static_cast<size_t>(row_of_b[k])]);
      }
    }
  }

  // The weights of these rows only, which are in order if they are all rows of
  // matrices that are sorted.
  std::span<const int> WeightsOf(std::span<const int> weights,
                                 const std::vector<size_t>& rows_a,
                                 const std::vector<size_t>& rows_b) {
    if (has_all_in_order_) return weights;
    weights_.clear();
    for (const size_t i : rows_a) {
      for (const size_t j : rows_b) {
        weights_.push_back(weights[i * b_.num_rows() + j]);
      }
    }
    return weights_;
  }

  const RelationMatrix& a_;
  const RelationMatrix& b_;
  std::vector<RoleGroup> groups_;
  bool has_all_in_order_;  // one group, of all rows
  EntryCounts counts_;
  Assignment assignment_;
  ColumnAlignment columns_;
  std::vector<int> lengths_, weights_;
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
