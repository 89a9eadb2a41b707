#include "common/sec/chain_alignment.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "common/sec/column_alignment.h"
#include "common/sec/row_subsequence.h"
#include "tests/unit/sec/matrix_testing.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::Pair;

// By the textbook's recursion.
int LongestCommon(std::span<const uint8_t> a, std::span<const uint8_t> b) {
  std::vector<std::vector<int>> best(a.size() + 1,
                                     std::vector<int>(b.size() + 1));
  for (size_t i = 1; i <= a.size(); ++i) {
    for (size_t j = 1; j <= b.size(); ++j) {
      best[i][j] = a[i - 1] == b[j - 1]
                       ? best[i - 1][j - 1] + 1
                       : std::max(best[i - 1][j], best[i][j - 1]);
    }
  }
  return best[a.size()][b.size()];
}

TEST(RowSubsequence, IsAsLongAsTheTextbookSaysInOneWordAndInSeveral) {
  std::mt19937_64 random(1);
  for (const size_t length : {1u, 7u, 63u, 64u, 65u, 128u, 200u}) {
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<uint8_t> a(length), b(1 + DrawBelow(150, random));
      for (auto* row : {&a, &b}) {
        for (uint8_t& symbol : *row) {
          symbol = static_cast<uint8_t>(DrawBelow(4, random));
        }
      }
      EXPECT_EQ(RowSubsequence(a).LengthWith(b), LongestCommon(a, b))
          << length << " and " << b.size();
    }
  }
}

TEST(EntryCounts, CountEqualEntriesOfLinesThatCorrespond) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 50; ++trial) {
    const RelationMatrix a = RandomMatrix(random);
    const RelationMatrix b = RandomMatrix(random);
    LinePairs rows, columns;
    for (size_t i = 0; i < a.num_rows(); ++i) {
      rows.emplace_back(i, DrawBelow(b.num_rows(), random));
    }
    for (size_t u = 0; u < a.num_columns(); ++u) {
      columns.emplace_back(u, DrawBelow(b.num_columns(), random));
    }
    EntryCounts counts(a, b);
    const auto of_columns = counts.OfColumns(rows);
    for (size_t u = 0; u < a.num_columns(); ++u) {
      for (size_t v = 0; v < b.num_columns(); ++v) {
        const auto expected = std::ranges::count_if(rows, [&](const auto& r) {
          return a.Symbol(r.first, u) == b.Symbol(r.second, v);
        });
        ASSERT_EQ(of_columns[u * b.num_columns() + v], expected);
      }
    }
    const auto of_rows = counts.OfRows(columns);
    for (size_t i = 0; i < a.num_rows(); ++i) {
      for (size_t j = 0; j < b.num_rows(); ++j) {
        const auto expected =
            std::ranges::count_if(columns, [&](const auto& c) {
              return a.Symbol(i, c.first) == b.Symbol(j, c.second);
            });
        ASSERT_EQ(of_rows[i * b.num_rows() + j], expected);
      }
    }
  }
}

// A count of more pairs than a lane of eight bits can hold.
TEST(EntryCounts, CountMorePairsThanALaneHas) {
  std::mt19937_64 random(5);
  const RelationMatrix a = RandomChain({0, 1, 2}, 100, random);
  LinePairs columns;
  for (size_t i = 0; i < 300; ++i) columns.emplace_back(i % 100, i % 100);
  EntryCounts counts(a, a);
  EXPECT_EQ(counts.OfRows(columns)[0], 300);
  columns.resize(255);
  EXPECT_EQ(counts.OfRows(columns)[0], 255);
  columns.resize(256, {0, 0});
  EXPECT_EQ(counts.OfRows(columns)[0], 256);
}

TEST(ColumnAlignment, KeepsTheOrderAndTakesTheLargestSum) {
  ColumnAlignment alignment;
  // The 9 crosses both 5s: one of it or two of them.
  const std::vector<int> gains = {0, 5, 0, 0, 0, 5, 9, 0, 0};
  EXPECT_EQ(alignment.Solve(gains, 3, 3), 10);
  EXPECT_THAT(alignment.Pairs(), ElementsAre(Pair(0, 1), Pair(1, 2)));
}

TEST(AlignChains, FindsRowsAndColumnsOfAShuffledChainWithAnInsertedColumn) {
  const RelationMatrix a = MatrixOf({"9019", "1101", "0122"}, {0, 0, 0});
  const RelationMatrix b = MatrixOf({"01022", "90219", "11901"}, {0, 0, 0});
  const ChainAlignment alignment = AlignChains(a, b, RowRoles::kIgnored);
  EXPECT_EQ(alignment.num_equal, 12);
  EXPECT_THAT(alignment.rows, ElementsAre(Pair(0, 1), Pair(1, 2), Pair(2, 0)));
  EXPECT_THAT(alignment.columns,
              ElementsAre(Pair(0, 0), Pair(1, 1), Pair(2, 3), Pair(3, 4)));
}

TEST(AlignChains, CountsWhatItSaysCorresponds) {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const RelationMatrix a = RandomMatrix(random);
    const RelationMatrix b = RandomMatrix(random);
    for (const RowRoles roles : {RowRoles::kIgnored, RowRoles::kKept}) {
      const ChainAlignment alignment = AlignChains(a, b, roles);
      int num_equal = 0;
      for (const auto& [i, j] : alignment.rows) {
        if (roles == RowRoles::kKept) {
          ASSERT_EQ(a.role(i), b.role(j));
        }
        for (const auto& [u, v] : alignment.columns) {
          num_equal += a.Symbol(i, u) == b.Symbol(j, v);
        }
      }
      ASSERT_EQ(alignment.num_equal, num_equal);
      ASSERT_TRUE(std::ranges::is_sorted(
          alignment.columns, [](const auto& x, const auto& y) {
            return x.first < y.first && x.second < y.second;
          }));
    }
  }
}

// Of chains of many sizes, with and without noise, sorted or not.
uint64_t DigestOfAlignments(RowRoles roles) {
  std::mt19937_64 random(6);
  uint64_t digest = 0;
  const auto put = [&](size_t value) {
    digest = (digest ^ value) * 1'099'511'628'211u;
  };
  for (int trial = 0; trial < 600; ++trial) {
    const size_t most = trial % 20 == 0 ? 40 : 9;
    std::vector<uint32_t> rows(1 + DrawBelow(most, random));
    for (uint32_t& role : rows) {
      role = static_cast<uint32_t>(DrawBelow(4, random));
    }
    const RelationMatrix a =
        RandomChain(rows, 2 + DrawBelow(most, random), random);
    const RelationMatrix b = trial % 2 == 0 ? WithNoise(a, {0.3}, random)
                                            : RandomMatrix(random).Sorted();
    const ChainAlignment alignment = AlignChains(a, b, roles);
    put(static_cast<size_t>(alignment.num_equal));
    for (const LinePairs* pairs : {&alignment.rows, &alignment.columns}) {
      for (const auto& [i, j] : *pairs) put(i * 1000 + j);
    }
  }
  return digest;
}

// Similarities of today stay comparable with those of yesterday: the digests
// are those of the first implementation.
TEST(AlignChains, AlwaysGivesTheSameOfSeveralBestAlignments) {
  EXPECT_EQ(DigestOfAlignments(RowRoles::kIgnored), 15953466694849279076u);
  EXPECT_EQ(DigestOfAlignments(RowRoles::kKept), 11916546841787422784u);
}

TEST(AlignChains, FindsAChainAmongMoreColumnsThanAWordHasBits) {
  std::mt19937_64 random(4);
  const RelationMatrix chain = RandomChain({0, 0, 0, 0}, 150, random);
  const RelationMatrix longer = WithNoise(chain, {0.9, false, {}}, random);
  const ChainAlignment alignment =
      AlignChains(chain, longer, RowRoles::kIgnored);
  EXPECT_GE(alignment.num_equal, 4 * 150 * 9 / 10);
}

}  // namespace
}  // namespace cell
