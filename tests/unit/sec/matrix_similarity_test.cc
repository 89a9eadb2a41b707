#include "common/sec/matrix_similarity.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <memory>

#include "common/sec/chain_similarities.h"
#include "common/sec/derivative_similarity.h"
#include "common/sec/joint_similarity.h"
#include "common/sec/paper_similarity.h"
#include "common/sec/typed_similarity.h"
#include "tests/unit/sec/matrix_testing.h"

namespace cell {
namespace {

class EveryMatrixSimilarity : public testing::TestWithParam<const char*> {
 protected:
  EveryMatrixSimilarity() : chain_measure_(MakeChainSimilarity(GetParam())) {}

  const MatrixSimilarity& measure() const {
    return dynamic_cast<const MatrixSimilarity&>(*chain_measure_);
  }

 private:
  std::unique_ptr<ChainSimilarity> chain_measure_;
};

INSTANTIATE_TEST_SUITE_P(All, EveryMatrixSimilarity,
                         testing::Values("paper", "derivative", "joint",
                                         "typed"));

TEST_P(EveryMatrixSimilarity, IsSymmetricFrom0To1And1WithItself) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 300; ++trial) {
    const RelationMatrix a = RandomMatrix(random);
    const RelationMatrix b = RandomMatrix(random);
    const double similarity = measure().Between(a, b);
    EXPECT_GE(similarity, 0);
    EXPECT_LE(similarity, 1);
    EXPECT_EQ(similarity, measure().Between(b, a));
    EXPECT_EQ(measure().Between(a, a), 1);
  }
}

TEST_P(EveryMatrixSimilarity, IgnoresTheOrderOfRows) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const RelationMatrix a = RandomMatrix(random);
    const RelationMatrix b = RandomMatrix(random);
    std::vector<size_t> rows, columns;
    for (size_t i = a.num_rows(); i > 0; --i) rows.push_back(i - 1);
    for (size_t u = 0; u < a.num_columns(); ++u) columns.push_back(u);
    EXPECT_EQ(measure().Between(a, b),
              measure().Between(a.Select(rows, columns), b));
  }
}

TEST_P(EveryMatrixSimilarity, FallsAsNoiseGrows) {
  std::mt19937_64 random(3);
  const RelationMatrix chain = RandomChain({0, 1, 2, 3, 4, 5, 0, 1}, 8, random);
  double last = 2;
  for (const double p : {0.0, 0.1, 0.3, 0.5}) {
    double mean = 0;
    for (int i = 0; i < 50; ++i) {
      mean += measure().Between(chain, WithNoise(chain, {p}, random)) / 50;
    }
    EXPECT_LT(mean, last) << p;
    last = mean;
  }
}

TEST_P(EveryMatrixSimilarity, OfChainsWithoutEntriesIs1OnlyIfBothHaveNone) {
  const RelationMatrix none;
  EXPECT_EQ(measure().Between(none, none), 1);
  EXPECT_EQ(measure().Between(none, MatrixOf({"01"})), 0);
  EXPECT_EQ(measure().Between(EventChain(), EventChain()), 1);
}

// Rows correspond, and three of four columns.
TEST(PaperSimilarity, DividesByTheLargerNumberOfColumns) {
  EXPECT_DOUBLE_EQ(PaperSimilarity().Between(MatrixOf({"901", "110"}),
                                             MatrixOf({"9021", "1190"})),
                   0.75);
}

TEST(PaperSimilarity, LeavesOutRowsThatCorrespondToNone) {
  EXPECT_EQ(PaperSimilarity().Between(MatrixOf({"901", "110"}),
                                      MatrixOf({"901", "110", "222"})),
            1);
}

TEST(JointSimilarity, CountsRowsThatCorrespondToNone) {
  EXPECT_DOUBLE_EQ(JointSimilarity().Between(MatrixOf({"901", "110"}),
                                             MatrixOf({"901", "110", "222"})),
                   2.0 * 6 / (6 + 9));
}

// The changes are the same, at other times.
TEST(DerivativeSimilarity, ComparesChangesNotRelations) {
  const DerivativeSimilarity derivative;
  // 0 1 and 1 1 against 1 0 and 0 0: no change in common.
  EXPECT_EQ(derivative.Between(MatrixOf({"011"}), MatrixOf({"100"})), 0);
  // Of two columns of changes, (0 1) is in both.
  EXPECT_DOUBLE_EQ(derivative.Between(MatrixOf({"011"}), MatrixOf({"001"})),
                   0.5);
}

TEST(TypedSimilarity, LetsOnlyRowsOfOneRoleCorrespond) {
  const RelationMatrix a = MatrixOf({"901", "110"}, {0, 1});
  const RelationMatrix swapped = MatrixOf({"110", "901"}, {0, 1});
  EXPECT_EQ(JointSimilarity().Between(a, swapped), 1);
  EXPECT_LT(TypedSimilarity().Between(a, swapped), 1);
  EXPECT_EQ(TypedSimilarity().Between(a, MatrixOf({"901", "110"}, {2, 3})), 0);
}

EventChain Lifting(const std::string& hand, const std::string& thing) {
  EventChain chain;
  for (const auto& [held, lying] : {std::pair{0, 1}, {1, 1}, {1, 0}}) {
    chain.Append(
        {{MakePair(hand, thing), Relation{static_cast<int8_t>(held)}},
         {MakePair(thing, "table"), Relation{static_cast<int8_t>(lying)}}});
  }
  return chain;
}

TEST(TypedSimilarity, TakesRolesFromTheTypesOfObjects) {
  const TypedSimilarity by_type({{"bolt_1", "bolt"}, {"bolt_2", "bolt"}});
  EXPECT_EQ(
      by_type.Between(Lifting("hand", "bolt_1"), Lifting("hand", "bolt_2")), 1);
  EXPECT_EQ(by_type.Between(Lifting("hand", "bolt_1"), Lifting("hand", "nut")),
            0);
  EXPECT_EQ(TypedSimilarity().Between(Lifting("hand", "bolt_1"),
                                      Lifting("hand", "bolt_2")),
            0);
}

}  // namespace
}  // namespace cell
