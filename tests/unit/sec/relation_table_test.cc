#include "common/sec/relation_table.h"

#include <gmock/gmock.h>

#include <stdexcept>
#include <utility>

namespace cell {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST(RelationTable, BecomesAChainOfWhatChanges) {
  const EventChain chain = ChainFromTable(
      "frame,hand_cup,table_cup,table_hand\r\n"
      "0,0,1,0\n"
      "1,0.49,1,0\n"
      "2,0.5,1.0,0\n"
      "5,1,9,0\n"
      "6,1,2,0\n\n",
      0.5, "a.csv");
  EXPECT_THAT(chain.pairs(), ElementsAre(ObjectPair{"cup", "hand"},
                                         ObjectPair{"cup", "table"}));
  EXPECT_EQ(ToText(chain), "cup, hand   0 1 1 1\ncup, table  1 1 9 2\n");
}

TEST(RelationTable, TakesTheThresholdThatIsGiven) {
  constexpr char kTable[] = "frame,a_b\n0,0.2\n1,0.6\n2,0.9\n";
  EXPECT_EQ(ToText(ChainFromTable(kTable, 0.5, "")), "a, b  0 1\n");
  EXPECT_EQ(ToText(ChainFromTable(kTable, 0.7, "")), "a, b  0 1\n");
  EXPECT_THROW(ChainFromTable(kTable, 0.1, ""), std::invalid_argument);
}

TEST(RelationTable, MayBeginWithAByteOrderMark) {
  constexpr char kTable[] =
      "\xef\xbb\xbf"
      "frame,a_b\n0,0\n1,1\n";
  EXPECT_EQ(ToText(ChainFromTable(kTable, 0.5, "")), "a, b  0 1\n");
}

TEST(RelationTable, SplitsNamesAtASlashIfThereIsOne) {
  const auto chain = ChainFromTable("frame,bolt_1/hand\n0,0\n1,1\n", 0.5, "");
  EXPECT_THAT(chain.pairs(), ElementsAre(ObjectPair{"bolt_1", "hand"}));
}

TEST(RelationTable, NamesFileAndLineOfWhatIsWrong) {
  const std::tuple<const char*, const char*, const char*> cases[] = {
      {"", "t.csv:1: ", "empty"},
      {"time,a_b\n", "t.csv:1: ", "'frame'"},
      {"frame\n", "t.csv:1: ", "a pair for each column"},
      {"frame,ab\n", "t.csv:1: ", "'ab' names no pair"},
      {"frame,a_\n", "t.csv:1: ", "'a_' names no pair"},
      {"frame,a_b,b_a\n", "t.csv:1: ", "twice"},
      {"frame,a_b,a_a\n", "t.csv:1: ", "'a_a' names one object twice"},
      {"frame,a_b\n", "t.csv:2: ", "no frame"},
      {"frame,a_b\n0,1\n1,1\n", "t.csv:4: ", "no relation changes"},
      {"frame,a_b\n0,1\n1,0,1\n", "t.csv:3: ", "3 values"},
      {"frame,a_b,a_c\n0,1\n", "t.csv:2: ", "2 values"},
      {"frame,a_b\n0,3\n", "t.csv:2: ", "'3' is no relation"},
      {"frame,a_b\n0,-0.1\n", "t.csv:2: ", "'-0.1' is no relation"},
      {"frame,a_b\n0,1.5\n", "t.csv:2: ", "'1.5' is no relation"},
      {"frame,a_b\n0,nan\n", "t.csv:2: ", "'nan' is no relation"},
      {"frame,a_b\n0,\n", "t.csv:2: ", "'' is no relation"},
      {"frame,a_b\n0,1x\n", "t.csv:2: ", "'1x' is no relation"},
      {"frame,a_b\n0.5,1\n", "t.csv:2: ", "no whole number"},
      {"frame,a_b\n0,1\n0,0\n", "t.csv:3: ", "frame 0 is there twice"},
      {"frame,a_b\n5,1\n4,0\n", "t.csv:3: ", "frame 4 after frame 5"}};
  for (const auto& [table, place, what] : cases) {
    try {
      ChainFromTable(table, 0.5, "t.csv");
      ADD_FAILURE() << table;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), StartsWith(place)) << table;
      EXPECT_THAT(error.what(), HasSubstr(what)) << table;
    }
  }
}

}  // namespace
}  // namespace cell
