#include "common/sec/role_matching.h"

#include <gmock/gmock.h>

#include <set>

namespace cell {
namespace {

std::set<RoleMap> All(size_t num_roles, size_t num_places) {
  std::set<RoleMap> all;
  ForEachMatching(num_roles, num_places, [&](const RoleMap& places) {
    EXPECT_EQ(places.size(), num_roles);
    EXPECT_EQ(places[0], 0u);
    EXPECT_TRUE(all.insert(places).second) << "twice";
  });
  return all;
}

TEST(RoleMatching, FillsEveryPlaceInEveryWayOnce) {
  EXPECT_EQ(All(1, 1).size(), 1u);
  EXPECT_EQ(All(3, 1).size(), 1u);
  EXPECT_EQ(All(3, 2).size(), 2u);
  EXPECT_EQ(All(5, 3).size(), 12u);  // 4 * 3
  EXPECT_EQ(All(4, 4).size(), 6u);
  EXPECT_TRUE(All(2, 3).empty());
  for (const RoleMap& places : All(5, 3)) {
    std::set<size_t> filled;
    for (const auto& place : places) {
      if (place) {
        EXPECT_TRUE(filled.insert(*place).second);
      }
    }
    EXPECT_EQ(filled, (std::set<size_t>{0, 1, 2}));
  }
}

}  // namespace
}  // namespace cell
