#include "common/sec/layered_chain.h"

#include <gmock/gmock.h>

#include <random>
#include <stdexcept>

#include "common/sec/chain_noise.h"
#include "common/sec/joint_similarity.h"
#include "common/sec/layered_similarity.h"
#include "common/sec/typed_similarity.h"

namespace cell {
namespace {

using testing::ElementsAre;

// A bolt is taken from the table and put down; a nut lies beside.
EventChain LiftedBolt() {
  EventChain chain;
  for (const auto& [held, lying] :
       {std::pair{0, 1}, {1, 1}, {1, 1}, {1, 0}, {0, 1}}) {
    chain.Append({{{"bolt", "hand"}, Relation{static_cast<int8_t>(held)}},
                  {{"bolt", "nut"}, Relation::kNotTouching},
                  {{"bolt", "table"}, Relation{static_cast<int8_t>(lying)}}});
  }
  return chain;
}

std::vector<RelationLayers> LayersOfLift() {
  std::vector<RelationLayers> layers(5);
  for (RelationLayers& of_frame : layers) {
    of_frame.places[{"bolt", "table"}] = Place::kOn;
  }
  layers[3].places[{"bolt", "table"}] = Place::kAbove;
  layers[1].motions[{"bolt", "hand"}] = Motion::kGettingCloser;
  layers[2].motions[{"bolt", "table"}] = Motion::kMovingApart;
  layers[4].motions[{"bolt", "hand"}] = Motion::kMovingTogether;
  return layers;
}

TEST(LayeredChain, HasRowsAndColumnsOfTouchingAndTheLastMotionSinceThen) {
  const LayeredChain chain =
      EnrichedRowsOf("bolt", LiftedBolt(), LayersOfLift());
  EXPECT_EQ(chain.touching,
            LiftedBolt().RowsOf("bolt").ChangingRows().DistinctColumns());
  EXPECT_EQ(ToText(chain),
            "bolt, hand   0   1>  1   0=\n"
            "bolt, table  1o  1o  0a< 1o\n");
  EXPECT_THAT(chain.places[1],
              ElementsAre(Place::kOn, Place::kOn, Place::kAbove, Place::kOn));
}

TEST(LayeredChain, SaysPlacesOfTheMovedPart) {
  std::vector<RelationLayers> layers(5);
  layers[0].places[{"bolt", "hand"}] = Place::kInside;
  const LayeredChain chain = EnrichedRowsOf("hand", LiftedBolt(), layers);
  EXPECT_EQ(chain.places[0][0], Place::kHolds);
}

TEST(LayeredChain, NeedsTheLayersOfEachColumn) {
  EXPECT_THROW(EnrichedRowsOf("bolt", LiftedBolt(), {}), std::invalid_argument);
}

LayeredChain RandomLayered(std::mt19937_64& random) {
  LayeredChain chain{"bolt", {}, {}, {}};
  const size_t num_columns = 2 + DrawBelow(5, random);
  const size_t num_rows = 1 + DrawBelow(4, random);
  for (size_t column = 0; column < num_columns; ++column) {
    TouchGraph graph;
    for (size_t row = 0; row < num_rows; ++row) {
      graph[{"bolt", "nut_" + std::to_string(row)}] =
          RelationOf(static_cast<uint8_t>(DrawBelow(4, random)));
    }
    chain.touching.Append(graph);
  }
  chain.places.resize(num_rows);
  chain.motions.resize(num_rows);
  for (size_t row = 0; row < num_rows; ++row) {
    for (size_t column = 0; column < num_columns; ++column) {
      chain.places[row].push_back(
          Place{static_cast<int8_t>(DrawBelow(7, random))});
      chain.motions[row].push_back(
          Motion{static_cast<int8_t>(DrawBelow(4, random))});
    }
  }
  return chain;
}

const ObjectTypes kTypes = {{"nut_0", "nut"}, {"nut_1", "nut"}};

TEST(LayeredSimilarity, IsSymmetricFrom0To1And1WithItself) {
  std::mt19937_64 random(1);
  for (const RowRoles roles : {RowRoles::kIgnored, RowRoles::kKept}) {
    const LayeredSimilarity similarity({roles, kTypes});
    for (int trial = 0; trial < 200; ++trial) {
      const LayeredChain a = RandomLayered(random), b = RandomLayered(random);
      const double value = similarity.Between(a, b);
      EXPECT_GE(value, 0);
      EXPECT_LE(value, 1);
      EXPECT_EQ(value, similarity.Between(b, a));
      EXPECT_EQ(similarity.Between(a, a), 1);
    }
  }
}

TEST(LayeredSimilarity, OfTouchingAloneIsThatOfTheMeasure) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const LayeredChain a = RandomLayered(random), b = RandomLayered(random);
    EXPECT_EQ(
        LayeredSimilarity({RowRoles::kIgnored, {}, false, false}).Between(a, b),
        JointSimilarity().Between(a.touching, b.touching));
    EXPECT_EQ(LayeredSimilarity({RowRoles::kKept, kTypes, false, false})
                  .Between(a, b),
              TypedSimilarity(kTypes).Between(a.touching, b.touching));
  }
}

TEST(LayeredSimilarity, TellsApartWhatTouchesAlikeButLiesElsewhere) {
  const LayeredChain on = EnrichedRowsOf("bolt", LiftedBolt(), LayersOfLift());
  auto layers = LayersOfLift();
  layers[4].places[{"bolt", "table"}] = Place::kInside;
  const LayeredChain inside = EnrichedRowsOf("bolt", LiftedBolt(), layers);
  EXPECT_EQ(
      LayeredSimilarity({RowRoles::kKept, {}, false, true}).Between(on, inside),
      1);
  // One of eight entries in one of two layers.
  EXPECT_DOUBLE_EQ(
      LayeredSimilarity({RowRoles::kKept, {}, true, false}).Between(on, inside),
      15.0 / 16);
}

}  // namespace
}  // namespace cell
