#include "common/sec/assignment.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace cell {
namespace {

using testing::ElementsAre;

int SumOf(const std::vector<int>& weights, std::span<const int> columns,
          size_t num_columns) {
  int sum = 0;
  for (size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] == Assignment::kNone) continue;
    sum += weights[i * num_columns + static_cast<size_t>(columns[i])];
  }
  return sum;
}

// Tries all permutations of the longer side.
int BestSum(const std::vector<int>& weights, size_t num_rows,
            size_t num_columns) {
  const size_t size = std::max(num_rows, num_columns);
  std::vector<size_t> order(size);
  std::iota(order.begin(), order.end(), size_t{0});
  int best = 0;
  do {
    int sum = 0;
    for (size_t i = 0; i < num_rows; ++i) {
      if (order[i] < num_columns) sum += weights[i * num_columns + order[i]];
    }
    best = std::max(best, sum);
  } while (std::ranges::next_permutation(order).found);
  return best;
}

TEST(Assignment, GivesUpTheBestOfOneRowForTheBestSum) {
  Assignment assignment;
  const std::vector<int> weights = {9, 8, 0, 9, 1, 0, 0, 0, 0};
  EXPECT_THAT(assignment.Solve(weights, 3, 3), ElementsAre(1, 0, 2));
}

TEST(Assignment, LeavesOutARowIfThereAreMoreRowsThanColumns) {
  Assignment assignment;
  const std::vector<int> weights = {5, 4, 1, 2, 7, 6};
  EXPECT_THAT(assignment.Solve(weights, 3, 2),
              ElementsAre(1, Assignment::kNone, 0));
}

TEST(Assignment, IsAsGoodAsTheBestOfAllPermutations) {
  std::mt19937_64 random(1);
  Assignment assignment;
  for (int trial = 0; trial < 300; ++trial) {
    const size_t num_rows = 1 + random() % 6;
    const size_t num_columns = 1 + random() % 6;
    std::vector<int> weights(num_rows * num_columns);
    for (int& weight : weights) weight = static_cast<int>(random() % 5);
    const auto columns = assignment.Solve(weights, num_rows, num_columns);
    ASSERT_EQ(columns.size(), num_rows);
    EXPECT_EQ(SumOf(weights, columns, num_columns),
              BestSum(weights, num_rows, num_columns));
    std::multiset<int> used(columns.begin(), columns.end());
    used.erase(Assignment::kNone);
    EXPECT_EQ(used.size(), std::min(num_rows, num_columns));
    for (const int column : used) EXPECT_EQ(used.count(column), 1u);
  }
}

}  // namespace
}  // namespace cell
