#include "common/planning/end_components.h"

#include <gmock/gmock.h>

#include <random>

namespace cell::planning {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(EndComponents, ACycleIsOneAndALeavingChoiceIsNone) {
  // 0 <-> 1, 1 -> {0, 2}, 2 -> nowhere
  EXPECT_THAT(EndComponents({{{1}}, {{0}, {0, 2}}, {}}),
              ElementsAre(ElementsAre(0, 1)));
  EXPECT_THAT(EndComponents({{{1}}, {{0, 2}}, {}}), IsEmpty());
}

TEST(EndComponents, WhatRestsOnALostChoiceIsLostToo) {
  // 0 -> 1 -> {0, 2}, 2 -> 3, 3 -> 2: only 2 and 3 can stay together.
  EXPECT_THAT(EndComponents({{{1}}, {{0, 2}}, {{3}}, {{2}}}),
              ElementsAre(ElementsAre(2, 3)));
}

TEST(EndComponents, ANodeThatStaysByItselfCounts) {
  EXPECT_THAT(EndComponents({{{0}}, {{0, 1}}}), ElementsAre(ElementsAre(0)));
}

TEST(EndComponents, ALongChainNeedsNoDeepStack) {
  LocalGraph graph(200'000);
  for (size_t i = 0; i < graph.size(); ++i) {
    graph[i] = {{static_cast<int>((i + 1) % graph.size())}};
  }
  EXPECT_EQ(EndComponents(graph).at(0).size(), graph.size());
}

/// By definition: the largest sets of nodes that are closed under some choices
/// and strongly connected by them, tried one by one.
bool IsEndComponent(const LocalGraph& graph, unsigned set) {
  const auto is_in = [&](int node) {
    return (set >> node & 1) != 0;
  };
  std::vector<unsigned> reach(graph.size());
  bool has_choice = true;
  for (size_t node = 0; node < graph.size(); ++node) {
    if (!is_in(static_cast<int>(node))) continue;
    bool stays = false;
    for (const auto& choice : graph[node]) {
      if (!std::ranges::all_of(choice, is_in)) continue;
      stays = true;
      for (const int target : choice) reach[node] |= 1u << target;
    }
    has_choice &= stays;
  }
  for (size_t k = 0; k < graph.size(); ++k) {
    for (size_t i = 0; i < graph.size(); ++i) {
      if ((reach[i] >> k & 1) != 0) reach[i] |= reach[k];
    }
  }
  for (size_t node = 0; node < graph.size(); ++node) {
    if (is_in(static_cast<int>(node)) && (reach[node] & set) != set) {
      return false;
    }
  }
  return set != 0 && has_choice;
}

TEST(EndComponents, RandomGraphsHaveExactlyTheMaximalOnes) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 300; ++trial) {
    LocalGraph graph(5);
    for (auto& choices : graph) {
      choices.resize(random() % 3);
      for (auto& choice : choices) {
        for (size_t i = 0; i <= random() % 2; ++i) {
          choice.push_back(static_cast<int>(random() % 5));
        }
      }
    }
    std::vector<unsigned> expected;
    for (unsigned set = 1; set < 32; ++set) {
      if (!IsEndComponent(graph, set)) continue;
      const bool is_maximal = [&] {
        for (unsigned more = set + 1; more < 32; ++more) {
          if ((more & set) == set && IsEndComponent(graph, more)) return false;
        }
        return true;
      }();
      if (is_maximal) expected.push_back(set);
    }
    std::vector<unsigned> found;
    for (const auto& component : EndComponents(graph)) {
      unsigned set = 0;
      for (const int node : component) set |= 1u << node;
      found.push_back(set);
    }
    EXPECT_THAT(found, testing::UnorderedElementsAreArray(expected));
  }
}

}  // namespace
}  // namespace cell::planning
