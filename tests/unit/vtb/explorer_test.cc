#include "services/vtb/explorer.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

namespace cell::vtb {
namespace {

TEST(Explorer, TriesEachRuleEquallyOften) {
  PlacementRule few;
  few.name = "few";
  PlacementRule many;
  many.name = "many";
  std::vector<Attempt> candidates = {{&few, "lid", "base.lid"}};
  for (const std::string site : {"base.a", "base.b", "base.c", "base.d"}) {
    candidates.push_back({&many, "peg", site});
  }
  std::mt19937_64 random(3);
  Explorer explorer;
  explorer.Begin(400);
  std::map<std::string, int> counts;
  std::map<std::string, int> sites;
  while (explorer.is_busy()) {
    const auto attempt = explorer.Next(candidates, random);
    ASSERT_TRUE(attempt);
    ++counts[attempt->rule->name];
    ++sites[attempt->site];
  }
  EXPECT_EQ(counts["few"] + counts["many"], 400);
  EXPECT_NEAR(counts["few"], 200, 50);
  EXPECT_EQ(sites.size(), 5U);
}

TEST(Explorer, IsDoneIfNothingCanBeTried) {
  std::mt19937_64 random(3);
  Explorer explorer;
  EXPECT_FALSE(explorer.is_busy());
  explorer.Begin(5);
  EXPECT_TRUE(explorer.is_busy());
  EXPECT_FALSE(explorer.ToTakeBack(random));
  EXPECT_FALSE(explorer.Next({}, random));
  EXPECT_FALSE(explorer.is_busy());
  EXPECT_FALSE(explorer.TakeFailure());
}

}  // namespace
}  // namespace cell::vtb
