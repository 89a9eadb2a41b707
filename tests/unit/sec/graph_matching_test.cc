#include "common/sec/graph_matching.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "common/sec/chain_noise.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::Optional;
using testing::Pair;

using Names = std::vector<std::string>;

Names NamesUpTo(size_t num) {
  Names names;
  for (size_t i = 0; i < num; ++i)
    names.push_back(std::string(1, static_cast<char>('a' + i)));
  return names;
}

// The kinds of half of the names; the others are kinds of their own.
ObjectTypes RandomKinds(const Names& names, std::mt19937_64& random) {
  ObjectTypes kinds;
  for (const std::string& name : names) {
    if (DrawBelow(4, random) > 0) {
      kinds[name] = DrawBelow(2, random) == 0 ? "nut" : "bolt";
    }
  }
  return kinds;
}

TouchGraph RandomGraph(const Names& names, size_t num_relations,
                       std::mt19937_64& random) {
  TouchGraph graph;
  for (size_t i = 0; i < names.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      graph[MakePair(names[i], names[j])] =
          RelationOf(static_cast<uint8_t>(DrawBelow(num_relations, random)));
    }
  }
  return graph;
}

std::string KindOf(const std::string& name, const ObjectTypes& kinds) {
  const auto it = kinds.find(name);
  return it == kinds.end() ? "only " + name : it->second;
}

bool IsMatch(const TouchGraph& a, const TouchGraph& b, const ObjectTypes& kinds,
             const ObjectMap& map) {
  return std::ranges::all_of(map,
                             [&](const auto& entry) {
                               return KindOf(entry.first, kinds) ==
                                      KindOf(entry.second, kinds);
                             }) &&
         std::ranges::all_of(a, [&](const auto& entry) {
           const auto& [first, second] = entry.first;
           return b.at(MakePair(map.at(first), map.at(second))) == entry.second;
         });
}

// By trying all permutations.
bool HasMatch(const TouchGraph& a, const TouchGraph& b,
              const ObjectTypes& kinds, const Names& names) {
  Names order = names;
  do {
    ObjectMap map;
    for (size_t i = 0; i < names.size(); ++i) map[names[i]] = order[i];
    if (IsMatch(a, b, kinds, map)) return true;
  } while (std::ranges::next_permutation(order).found);
  return false;
}

TouchGraph Renamed(const TouchGraph& graph, const ObjectMap& map) {
  TouchGraph renamed;
  for (const auto& [pair, relation] : graph) {
    renamed[MakePair(map.at(pair.first), map.at(pair.second))] = relation;
  }
  return renamed;
}

TEST(MatchGraphs, FindsAMatchIfAndOnlyIfSomePermutationIsOne) {
  std::mt19937_64 random(1);
  std::array<int, 2> num{};
  for (int trial = 0; trial < 400; ++trial) {
    const Names names = NamesUpTo(2 + DrawBelow(5, random));
    const ObjectTypes kinds = RandomKinds(names, random);
    const TouchGraph a = RandomGraph(names, 2 + trial % 2, random);
    TouchGraph b = RandomGraph(names, 2 + trial % 2, random);
    if (trial % 4 != 0) {  // the same graph, perhaps with one change
      Names order = names;
      for (size_t i = order.size(); i > 1; --i) {
        std::swap(order[i - 1], order[DrawBelow(i, random)]);
      }
      ObjectMap map;
      for (size_t i = 0; i < names.size(); ++i) map[names[i]] = order[i];
      b = Renamed(a, map);
      if (trial % 4 == 1) b.begin()->second = Relation::kTouching;
    }
    const auto match = MatchGraphs(a, b, kinds);
    const bool has_match = HasMatch(a, b, kinds, names);
    ASSERT_EQ(match.has_value(), has_match);
    ++num[has_match];
    if (match) {
      EXPECT_TRUE(IsMatch(a, b, kinds, *match));
    }
  }
  EXPECT_GT(num[0], 50);
  EXPECT_GT(num[1], 50);
}

TEST(MatchGraphs, TellsTwoTrianglesFromARing) {
  const auto with = [](const std::vector<ObjectPair>& touching) {
    std::mt19937_64 none;
    TouchGraph graph = RandomGraph(NamesUpTo(6), 1, none);
    for (const ObjectPair& pair : touching) graph[pair] = Relation::kTouching;
    return graph;
  };
  ObjectTypes alike;
  for (const std::string& name : NamesUpTo(6)) alike[name] = "nut";
  const TouchGraph ring = with(
      {{"a", "b"}, {"b", "c"}, {"c", "d"}, {"d", "e"}, {"e", "f"}, {"a", "f"}});
  const TouchGraph triangles = with(
      {{"a", "b"}, {"b", "c"}, {"a", "c"}, {"d", "e"}, {"e", "f"}, {"d", "f"}});
  EXPECT_FALSE(MatchGraphs(ring, triangles, alike));
  EXPECT_TRUE(MatchGraphs(ring, ring, alike));
}

TEST(MatchGraphs, LetsNothingBeWhatItIsNotUnlessTheyAreAlike) {
  const TouchGraph a = {{{"nut_1", "table"}, Relation::kTouching},
                        {{"nut_2", "table"}, Relation::kNotTouching},
                        {{"nut_1", "nut_2"}, Relation::kNotTouching}};
  const TouchGraph b = {{{"nut_1", "table"}, Relation::kNotTouching},
                        {{"nut_2", "table"}, Relation::kTouching},
                        {{"nut_1", "nut_2"}, Relation::kNotTouching}};
  EXPECT_FALSE(MatchGraphs(a, b, {}));
  EXPECT_THAT(
      MatchGraphs(a, b, {{"nut_1", "nut"}, {"nut_2", "nut"}}),
      Optional(ElementsAre(Pair("nut_1", "nut_2"), Pair("nut_2", "nut_1"),
                           Pair("table", "table"))));
  EXPECT_THAT(
      MatchGraphs(a, a, {{"nut_1", "nut"}, {"nut_2", "nut"}}),
      Optional(ElementsAre(Pair("nut_1", "nut_1"), Pair("nut_2", "nut_2"),
                           Pair("table", "table"))));
}

TEST(MatchGraphs, OfGraphsOfOtherObjectsFindsNone) {
  const TouchGraph a = {{{"nut", "table"}, Relation::kTouching}};
  const TouchGraph b = {{{"bolt", "table"}, Relation::kTouching}};
  EXPECT_FALSE(MatchGraphs(a, b, {}));
  EXPECT_FALSE(MatchGraphs(a, {}, {}));
  EXPECT_TRUE(MatchGraphs({}, {}, {}));
}

}  // namespace
}  // namespace cell
