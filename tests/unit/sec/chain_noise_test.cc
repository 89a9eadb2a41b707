#include "common/sec/chain_noise.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

#include "tests/unit/sec/matrix_testing.h"

namespace cell {
namespace {

RelationMatrix Seed() {
  return MatrixOf({"91119", "90109", "11011", "02220"}, {0, 1, 2, 2});
}

double ShareOfEqualEntries(const RelationMatrix& a, const RelationMatrix& b) {
  double num_equal = 0;
  for (size_t i = 0; i < a.num_rows(); ++i) {
    for (size_t j = 0; j < a.num_columns(); ++j) {
      num_equal += a.Symbol(i, j) == b.Symbol(i, j);
    }
  }
  return num_equal / static_cast<double>(a.num_entries());
}

TEST(ChainNoise, OfProbability0OnlyChangesTheOrderOfRows) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(WithNoise(Seed(), {0}, random).Sorted(), Seed().Sorted());
  }
}

TEST(ChainNoise, OfProbability1FillsEveryInnerGap) {
  std::mt19937_64 random(2);
  for (const bool flips : {true, false}) {
    const RelationMatrix noisy = WithNoise(Seed(), {1, flips, {}}, random);
    EXPECT_EQ(noisy.num_rows(), 7u);
    EXPECT_EQ(noisy.num_columns(), 9u);
  }
}

TEST(ChainNoise, WithoutFlipsKeepsTheOriginalEntries) {
  std::mt19937_64 random(3);
  const RelationMatrix noisy = WithNoise(Seed(), {1, false, {}}, random);
  // Every second column is original; so are four of the rows.
  for (size_t row = 0; row < Seed().num_rows(); ++row) {
    const auto is_original = [&](size_t i) {
      for (size_t j = 0; j < Seed().num_columns(); ++j) {
        if (noisy.Symbol(i, 2 * j) != Seed().Symbol(row, j)) return false;
      }
      return noisy.role(i) == Seed().role(row);
    };
    bool is_there = false;
    for (size_t i = 0; i < noisy.num_rows(); ++i) is_there |= is_original(i);
    EXPECT_TRUE(is_there) << row;
  }
}

TEST(ChainNoise, ChangesAndInsertsAsOftenAsTheProbabilitySays) {
  std::mt19937_64 random(4);
  const RelationMatrix one_row = MatrixOf({"0129012901290129"});
  double equal = 0, columns = 0;
  constexpr int kTrials = 2000;
  for (int i = 0; i < kTrials; ++i) {
    const auto noisy = WithNoise(one_row, {0.3}, random);
    columns += static_cast<double>(noisy.num_columns());
    // The first column has no gap before it.
    equal += noisy.Symbol(0, 0) == one_row.Symbol(0, 0);
  }
  EXPECT_NEAR(equal / kTrials, 0.7, 0.05);
  EXPECT_NEAR(columns / kTrials, 16 + 15 * 0.3, 0.2);
}

TEST(ChainNoise, DrawsRolesOfInsertedRowsFromThoseGiven) {
  std::mt19937_64 random(5);
  const RelationMatrix noisy = WithNoise(Seed(), {1, true, {7, 8}}, random);
  const auto is_inserted = [](uint32_t role) {
    return role == 7 || role == 8;
  };
  EXPECT_EQ(std::ranges::count_if(noisy.roles(), is_inserted), 3);
}

TEST(ChainNoise, IsTheSameForTheSameSeed) {
  std::mt19937_64 random(6), same(6), other(7);
  const RelationMatrix noisy = WithNoise(Seed(), {0.5}, random);
  EXPECT_EQ(noisy, WithNoise(Seed(), {0.5}, same));
  EXPECT_NE(noisy, WithNoise(Seed(), {0.5}, other));
}

TEST(RandomChain, ChangesInEveryRowAndBetweenAllColumns) {
  std::mt19937_64 random(7);
  double equal = 0;
  const RelationMatrix first = RandomChain({0, 0, 1}, 4, random);
  for (int i = 0; i < 200; ++i) {
    const RelationMatrix chain = RandomChain({0, 0, 1}, 4, random);
    ASSERT_EQ(chain.Changing(), chain);
    equal += ShareOfEqualEntries(first, chain) / 200;
  }
  EXPECT_NEAR(equal, 0.25, 0.05);
  EXPECT_THROW(RandomChain({0}, 1, random), std::invalid_argument);
}

}  // namespace
}  // namespace cell
