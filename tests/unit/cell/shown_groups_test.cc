#include "services/cell/evaluations/shown_groups.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

/// A part is taken from the table and put onto others, a column each.
ShownChain Put(const std::string& action, const std::string& part,
               const std::string& site, const std::vector<std::string>& onto) {
  ShownChain shown{action, part, site, {}};
  const size_t num_columns = 4 + onto.size();
  for (size_t column = 0; column < num_columns; ++column) {
    TouchGraph graph;
    const auto set = [&](const std::string& other, bool touches) {
      graph[MakePair(part, other)] =
          touches ? Relation::kTouching : Relation::kNotTouching;
    };
    set("hand_right", column > 0 && column + 1 < num_columns);
    set("table", column < 2);
    for (size_t i = 0; i < onto.size(); ++i) set(onto[i], column >= 3 + i);
    shown.chain.Append(graph);
  }
  return shown;
}

std::vector<ShownChain> Shown() {
  std::vector<ShownChain> all;
  for (int i = 0; i < 10; ++i) {
    all.push_back(Put("Round", "round_peg_1", "base.round_1", {"base"}));
    all.push_back(Put("Square", "square_peg_1", "base.square_1", {"base"}));
    all.push_back(Put("Hang", "pendulum", "base.pendulum",
                      {"shaft", "base", "separator"}));
  }
  return all;
}

const ShownGrouping& Grouping(const std::string& name) {
  static const auto groupings = ShownGroupings();
  return *std::ranges::find(groupings, name, &ShownGrouping::name);
}

TEST(ShownGroups, TypesKeepActionsApart) {
  const ShippedTask task;
  const auto groups = GroupChains(Shown(), task, Grouping("typed"), 1);
  EXPECT_EQ(groups.models.size(), 3u);
  EXPECT_EQ(groups.num_all, 30);
  EXPECT_EQ(groups.num_pure, 30);
  EXPECT_EQ(groups.num_objects, 10 * (4 + 4 + 6));
  EXPECT_EQ(groups.num_objects_pure, groups.num_objects);
  EXPECT_LT(groups.num_objects_pure_shuffled, groups.num_objects * 3 / 4);
}

TEST(ShownGroups, WithoutTypesTheSameTopologyIsOneAndNothingElse) {
  const ShippedTask task;
  const auto groups =
      GroupChains(Shown(), task, Grouping("joint, highest cut"), 1);
  EXPECT_EQ(groups.models.size(), 2u);
  EXPECT_EQ(groups.num_pure, 20);
  EXPECT_EQ(groups.num_same, 10);
  EXPECT_EQ(groups.num_ambiguous, 20);
  EXPECT_EQ(groups.num_ambiguous_merged, 20);
}

}  // namespace
}  // namespace cell
