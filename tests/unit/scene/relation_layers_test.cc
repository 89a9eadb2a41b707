#include "common/scene/relation_layers.h"

#include <gtest/gtest.h>

namespace cell {
namespace {

SceneObjects Scene() {
  const PartTable parts = PartTable::FromConfig(Config::Parse(R"(
contacts: []
parts:
  bolt: &part
    type: t
    symmetry_order: 1
    density: 1000
    colour: [1, 1, 1]
    pieces: [{kind: box, center: [0, 0, 0], size: [20, 20, 20]}]
  nut: *part
)",
                                                              "parts.yaml"));
  return {parts, {"hand"}};
}

RelationLayers SomeLayers() {
  return {3,
          {{{"bolt", "table"}, Place::kOn}, {{"bolt", "nut"}, Place::kInside}},
          {{{"bolt", "hand"}, Motion::kMovingTogether},
           {{"bolt", "table"}, Motion::kMovingApart}}};
}

TEST(RelationLayers, StayTheSameAsAMessage) {
  const relation_layers_t message = LayersToMessage(SomeLayers(), 5);
  EXPECT_EQ(message.header.utime, 5);
  EXPECT_EQ(message.num_relations, 3);
  EXPECT_EQ(LayersFromMessage(message, Scene()), SomeLayers());
}

TEST(RelationLayers, OfAMessageThatMakesNoSenseAreNone) {
  const auto refuses = [](auto change) {
    relation_layers_t message = LayersToMessage(SomeLayers(), 5);
    change(message);
    return !LayersFromMessage(message, Scene());
  };
  EXPECT_TRUE(refuses([](auto& m) { m.key_frame = -1; }));
  EXPECT_TRUE(refuses([](auto& m) { m.relations[0].place = 7; }));
  EXPECT_TRUE(refuses([](auto& m) { m.relations[0].motion = -1; }));
  EXPECT_TRUE(refuses([](auto& m) { m.relations[0].second = "screw"; }));
  EXPECT_TRUE(refuses([](auto& m) { m.relations[1] = m.relations[0]; }));
  EXPECT_TRUE(refuses(
      [](auto& m) { m.relations[0].place = m.relations[0].motion = 0; }));
  EXPECT_TRUE(refuses(
      [](auto& m) { std::swap(m.relations[0].first, m.relations[0].second); }));
}

TEST(RelationLayers, AreSaidOfEitherObject) {
  const RelationLayers layers = SomeLayers();
  EXPECT_EQ(layers.PlaceOf("bolt", "nut"), Place::kInside);
  EXPECT_EQ(layers.PlaceOf("nut", "bolt"), Place::kHolds);
  EXPECT_EQ(layers.PlaceOf("nut", "hand"), Place::kNone);
  EXPECT_EQ(layers.MotionOf("hand", "bolt"), Motion::kMovingTogether);
}

TEST(Mirrored, TwiceIsTheSame) {
  for (int8_t code = 0; code <= 6; ++code) {
    const Place place{code};
    EXPECT_EQ(Mirrored(Mirrored(place)), place);
    EXPECT_EQ(Mirrored(place) == place, place == Place::kNone);
  }
}

}  // namespace
}  // namespace cell
