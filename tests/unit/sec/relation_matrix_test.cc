#include "common/sec/relation_matrix.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "tests/unit/sec/matrix_testing.h"

namespace cell {
namespace {

TEST(RelationMatrix, HasTheRelationsOfAChainAndTheRolesOfItsPairs) {
  EventChain chain;
  chain.Append({{{"bolt_1", "hand"}, Relation::kAbsent},
                {{"bolt_2", "hand"}, Relation::kOverlapping}});
  chain.Append({{{"bolt_1", "hand"}, Relation::kTouching},
                {{"bolt_2", "hand"}, Relation::kNotTouching}});
  RoleTable by_name, by_type({{"bolt_1", "bolt"}, {"bolt_2", "bolt"}});
  EXPECT_EQ(RelationMatrix(chain, &by_name), MatrixOf({"91", "20"}, {0, 1}));
  EXPECT_EQ(RelationMatrix(chain, &by_type), MatrixOf({"91", "20"}, {0, 0}));
  EXPECT_EQ(ToText(RelationMatrix(chain, &by_name)), " 9 1\n 2 0\n");
}

TEST(RoleTable, KnowsATypeOnEitherSideOfAPair) {
  RoleTable roles({{"a", "thing"}, {"z", "thing"}});
  EXPECT_EQ(roles.RoleOf({"a", "hand"}), roles.RoleOf({"hand", "z"}));
  EXPECT_NE(roles.RoleOf({"a", "hand"}), roles.RoleOf({"a", "table"}));
}

TEST(RelationMatrix, SortedIsTheSameForEveryOrderOfRows) {
  const RelationMatrix a = MatrixOf({"01", "00", "91"}, {1, 0, 1});
  const RelationMatrix b = MatrixOf({"91", "01", "00"}, {1, 1, 0});
  EXPECT_FALSE(a.IsSorted());
  EXPECT_TRUE(a.Sorted().IsSorted());
  EXPECT_EQ(a.Sorted(), b.Sorted());
}

TEST(RelationMatrix, ChangingDropsRowsAndColumnsThatSayNothing) {
  EXPECT_EQ(MatrixOf({"0011", "1111", "1100"}, {4, 5, 6}).Changing(),
            MatrixOf({"01", "10"}, {4, 6}));
  EXPECT_TRUE(MatrixOf({"111"}).Changing().is_empty());
}

TEST(RelationMatrix, RefusesMoreColumnsThanItCanCount) {
  EXPECT_THROW(RelationMatrix({0}, RelationMatrix::kMaxSize + 1),
               std::invalid_argument);
}

}  // namespace
}  // namespace cell
