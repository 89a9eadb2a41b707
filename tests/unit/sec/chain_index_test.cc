#include "common/sec/chain_index.h"

#include <gmock/gmock.h>

#include "tests/unit/sec/matrix_testing.h"

namespace cell {
namespace {

ChainIndex::Match ByExhaustiveSearch(const ChainIndex& index,
                                     const RelationMatrix& query) {
  const TypedSimilarity similarity;
  ChainIndex::Match best{0, -1, index.size()};
  for (size_t i = 0; i < index.size(); ++i) {
    const double value = similarity.Between(query, index.model(i));
    if (value > best.similarity) best = {i, value, index.size()};
  }
  return best;
}

TEST(ChainIndex, FindsWhatExhaustiveSearchFinds) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 10; ++trial) {
    ChainIndex index;
    for (int i = 0; i < 100; ++i) index.Add(RandomMatrix(random));
    for (int i = 0; i < 10; ++i) {
      const RelationMatrix query =
          i % 2 == 0
              ? RandomMatrix(random)
              : WithNoise(index.model(DrawBelow(100, random)), {0.2}, random);
      const auto expected = ByExhaustiveSearch(index, query);
      const auto found = index.MostSimilar(query);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->model, expected.model);
      EXPECT_EQ(found->similarity, expected.similarity);
    }
  }
}

TEST(ChainIndex, ComparesFewModelsIfOneIsEqualToTheQuery) {
  std::mt19937_64 random(2);
  ChainIndex index;
  for (int i = 0; i < 500; ++i) {
    index.Add(RandomChain({0, 1, 2, 3}, 8, random));
  }
  const auto found = index.MostSimilar(index.model(321));
  EXPECT_EQ(found->model, 321u);
  EXPECT_EQ(found->similarity, 1);
  EXPECT_LT(found->num_compared, 50u);
}

TEST(ChainIndex, WithoutModelsOrEntriesSaysSo) {
  ChainIndex index;
  EXPECT_FALSE(index.MostSimilar(MatrixOf({"01"})));
  index.Add(MatrixOf({"01"}));
  EXPECT_EQ(index.MostSimilar(RelationMatrix())->similarity, 0);
}

}  // namespace
}  // namespace cell
