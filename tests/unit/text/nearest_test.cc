// The nearest known name for a mistyped one, and counted nouns.
#include "common/text/nearest.h"

#include <gtest/gtest.h>

#include "common/text/counted.h"

namespace cell {
namespace {

TEST(Nearest, IsFoundThroughOneSlipOfEachKind) {
  const std::vector<std::string> names = {"watch", "assembly", "stops"};
  EXPECT_EQ(NearestOf("wach", names), "watch");        // dropped
  EXPECT_EQ(NearestOf("watchh", names), "watch");      // added
  EXPECT_EQ(NearestOf("wotch", names), "watch");       // changed
  EXPECT_EQ(NearestOf("wacth", names), "watch");       // swapped
  EXPECT_EQ(NearestOf("asembli", names), "assembly");  // two slips of seven
}

TEST(Nearest, IsNothingWhereNothingIsNear) {
  EXPECT_EQ(NearestOf("goal", {"watch", "assembly"}), "");
  EXPECT_EQ(NearestOf("watch", {}), "");
  EXPECT_EQ(NearestOf(std::string(100'000, 'w'), {"watch"}), "");
}

TEST(Nearest, OfSeveralIsTheNearestThenTheFirst) {
  EXPECT_EQ(NearestOf("peg_3", {"leg_30", "peg_1", "peg_2"}), "peg_1");
}

TEST(Nearest, FollowsAnErrorWithAllThatAreKnown) {
  EXPECT_EQ(NamesInstead("wach", {"watch", "stops"}),
            "; did you mean 'watch'? Known: watch, stops");
  EXPECT_EQ(NamesInstead("x", {"watch"}), "; known: watch");
  EXPECT_EQ(NamesInstead("x", {}), "; known: none");
}

TEST(Counted, HasSingularAndPlural) {
  EXPECT_EQ(Counted(0, "step"), "0 steps");
  EXPECT_EQ(Counted(1, "step"), "1 step");
  EXPECT_EQ(Counted(2, "step"), "2 steps");
  EXPECT_EQ(Counted(2, "branch", "branches"), "2 branches");
}

}  // namespace
}  // namespace cell
