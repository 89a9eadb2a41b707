#include "common/sec/event_chain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "common/sec/same_pair_similarity.h"
#include "common/sec/same_row_similarity.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr Relation kApart = Relation::kNotTouching;
constexpr Relation kTouch = Relation::kTouching;

TouchGraph Column(Relation hand_peg, Relation peg_table) {
  return {{{"hand", "peg"}, hand_peg},
          {{"hand", "table"}, kApart},
          {{"peg", "table"}, peg_table}};
}

// The hand comes, lifts the peg, puts it down, leaves.
EventChain PickAndPlace() {
  EventChain chain;
  chain.Append(Column(kApart, kTouch));
  chain.Append(Column(kTouch, kTouch));
  chain.Append(Column(kTouch, kApart));
  chain.Append(Column(kTouch, kTouch));
  chain.Append(Column(kApart, kTouch));
  return chain;
}

EventChain Random(std::mt19937_64& random, size_t num_columns) {
  EventChain chain;
  for (size_t i = 0; i < num_columns; ++i) {
    const auto relation = [&] {
      return random() % 2 == 0 ? kApart : kTouch;
    };
    chain.Append(Column(relation(), relation()));
  }
  return chain;
}

TEST(EventChain, HasARowForEachPairAndAColumnForEachKeyFrame) {
  const EventChain chain = PickAndPlace();
  EXPECT_EQ(chain.num_columns(), 5u);
  EXPECT_THAT(chain.pairs(), ElementsAre(ObjectPair{"hand", "peg"},
                                         ObjectPair{"hand", "table"},
                                         ObjectPair{"peg", "table"}));
  EXPECT_EQ(chain.FindRow({"peg", "table"}), 2u);
  EXPECT_EQ(chain.FindRow({"peg", "tablet"}), std::nullopt);
  EXPECT_THAT(chain.Row(2),
              ElementsAre(kTouch, kTouch, kApart, kTouch, kTouch));
  EXPECT_EQ(chain.At(0, 1), kTouch);
  EXPECT_THROW(chain.At(3, 0), std::out_of_range);
}

TEST(EventChain, RefusesAColumnOfOtherPairs) {
  EventChain chain = PickAndPlace();
  try {
    chain.Append({{{"hand", "peg"}, kTouch}});
    FAIL() << "took it";
  } catch (const std::invalid_argument& e) {
    EXPECT_THAT(e.what(), HasSubstr("1 pairs for a chain of other 3"));
  }
  EXPECT_EQ(chain, PickAndPlace());
}

TEST(EventChain, SlicesPutTogetherAreTheChain) {
  const EventChain chain = PickAndPlace();
  for (size_t cut = 0; cut <= chain.num_columns(); ++cut) {
    const EventChain left = chain.Slice(0, cut);
    const EventChain right = chain.Slice(cut, chain.num_columns());
    EXPECT_EQ(left.num_columns() + right.num_columns(), chain.num_columns());
    for (size_t row = 0; row < left.num_rows(); ++row) {
      for (size_t i = 0; i < cut; ++i) {
        EXPECT_EQ(left.At(row, i), chain.At(row, i));
      }
    }
    for (size_t row = 0; row < right.num_rows(); ++row) {
      EXPECT_EQ(right.At(row, 0), chain.At(row, cut));
    }
  }
  EXPECT_EQ(chain.Slice(2, 2), EventChain());
  EXPECT_THROW(chain.Slice(3, 2), std::out_of_range);
  EXPECT_THROW(chain.Slice(0, 6), std::out_of_range);
}

TEST(EventChain, KeepsTheRowsThatChange) {
  const EventChain changing = PickAndPlace().ChangingRows();
  EXPECT_THAT(changing.pairs(), ElementsAre(ObjectPair{"hand", "peg"},
                                            ObjectPair{"peg", "table"}));
  EXPECT_EQ(changing.num_columns(), 5u);
  EXPECT_EQ(changing.ChangingRows(), changing);
  EXPECT_EQ(PickAndPlace().Slice(0, 1).ChangingRows().num_rows(), 0u);
}

TEST(EventChain, KeepsTheRowsOfAnObject) {
  EXPECT_THAT(
      PickAndPlace().RowsOf("table").pairs(),
      ElementsAre(ObjectPair{"hand", "table"}, ObjectPair{"peg", "table"}));
}

TEST(EventChain, KeepsTheColumnsThatDiffer) {
  const EventChain of_table = PickAndPlace().RowsOf("table").DistinctColumns();
  EXPECT_EQ(of_table.num_columns(), 3u);
  EXPECT_THAT(of_table.Row(1), ElementsAre(kTouch, kApart, kTouch));
  EXPECT_EQ(of_table.DistinctColumns(), of_table);
}

TEST(EventChain, IsEqualToOneWithTheSamePairsAndEntries) {
  EXPECT_EQ(PickAndPlace(), PickAndPlace());
  EventChain longer = PickAndPlace();
  longer.Append(Column(kApart, kTouch));
  EXPECT_NE(longer, PickAndPlace());
  EXPECT_EQ(longer.DistinctColumns(), PickAndPlace());
}

TEST(EventChain, IsShownAsItsTable) {
  EXPECT_EQ(ToText(PickAndPlace().ChangingRows()),
            "hand, peg   0 1 1 1 0\n"
            "peg, table  1 1 0 1 1\n");
  EXPECT_EQ(ToText(EventChain()), "");
}

TEST(SamePairSimilarity, IsOneWithItselfAndTheSameBothWays) {
  const SamePairSimilarity similarity;
  std::mt19937_64 random(5);
  for (int i = 0; i < 50; ++i) {
    const EventChain a = Random(random, 1 + random() % 6);
    const EventChain b = Random(random, 1 + random() % 6);
    EXPECT_EQ(similarity.Between(a, a), 1);
    EXPECT_EQ(similarity.Between(a, b), similarity.Between(b, a));
    EXPECT_GE(similarity.Between(a, b), 0);
    EXPECT_LE(similarity.Between(a, b), 1);
    if (a.num_columns() == b.num_columns() && a != b) {
      EXPECT_LT(similarity.Between(a, b), 1);
    }
  }
}

TEST(SamePairSimilarity, AlignsColumnsInTheirOrder) {
  const SamePairSimilarity similarity;
  const EventChain chain = PickAndPlace().ChangingRows();
  // Without the first key frame four of five columns correspond.
  EXPECT_DOUBLE_EQ(similarity.Between(chain, chain.Slice(1, 5)), 4.0 / 5);
  EventChain flipped;
  for (size_t column = 0; column < 5; ++column) {
    flipped.Append(
        {{{"hand", "peg"}, chain.At(0, column)}, {{"peg", "table"}, kTouch}});
  }
  // One entry of ten differs.
  EXPECT_DOUBLE_EQ(similarity.Between(chain, flipped), 9.0 / 10);
}

TEST(SamePairSimilarity, CountsRowsThatOnlyOneOfThemHas) {
  const SamePairSimilarity similarity;
  const EventChain chain = PickAndPlace();
  EXPECT_DOUBLE_EQ(similarity.Between(chain, chain.ChangingRows()), 2.0 / 3);
  EXPECT_DOUBLE_EQ(similarity.Between(chain.RowsOf("hand").RowsOf("table"),
                                      chain.RowsOf("peg").RowsOf("table")),
                   0);
}

TEST(SameRowSimilarity, DoesNotCountHowLongARelationLasts) {
  const SameRowSimilarity similarity;
  EventChain slow = PickAndPlace();
  slow.Append(Column(kApart, kTouch));
  EXPECT_DOUBLE_EQ(similarity.Between(slow, PickAndPlace()), 1);
  std::mt19937_64 random(1);
  EXPECT_LT(similarity.Between(Random(random, 9), PickAndPlace()), 1);
}

TEST(SamePairSimilarity, TakesEmptyChainsAsAlike) {
  const SamePairSimilarity similarity;
  EXPECT_EQ(similarity.Between({}, {}), 1);
  EXPECT_EQ(similarity.Between({}, PickAndPlace()), 0);
}

}  // namespace
}  // namespace cell
