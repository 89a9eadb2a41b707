#include "services/sec_builder/layer_sensor.h"

#include <gtest/gtest.h>

#include <vector>

namespace cell {

using namespace sec_builder;
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

// A tray of 200 x 200 x 40 mm, a block of 20 mm, a hand and the table.
class LayerSensorTest : public testing::Test {
 protected:
  static PartTable Parts() {
    return PartTable::FromConfig(Config::Parse(R"(
contacts: []
parts:
  block:
    type: block
    symmetry_order: 1
    density: 1000
    colour: [1, 1, 1]
    pieces: [{kind: box, center: [0, 0, 0], size: [20, 20, 20]}]
  tray:
    type: tray
    symmetry_order: 1
    density: 1000
    colour: [1, 1, 1]
    pieces: [{kind: box, center: [0, 0, 0], size: [200, 200, 40]}]
)",
                                               "parts.yaml"));
  }

  /// A second later: in m, the middle of each.
  RelationLayers Next(const Vector3d& block, const Vector3d& tray,
                      const Vector3d& hand) {
    utime_ += 1'000'000;
    Tracks tracks{utime_, {}};
    tracks.tracks = {
        {"block",
         Track::State::kTracked,
         1,
         Isometry3d(Translation3d(block)),
         {}},
        {"hand",
         Track::State::kTracked,
         1,
         Isometry3d::Identity(),
         {hand - Vector3d::Constant(0.03), hand + Vector3d::Constant(0.03)}},
        {"tray",
         Track::State::kTracked,
         1,
         Isometry3d(Translation3d(tray)),
         {}}};
    sensor_.Update(tracks);
    return sensor_.Sense(FrameNow());
  }
  KeyFrame FrameNow() const {
    KeyFrame frame;
    frame.utime = utime_;
    for (const std::string& a : scene_objects_.names()) {
      for (const std::string& b : scene_objects_.names()) {
        if (a < b) frame.relations[{a, b}] = Relation::kNotTouching;
      }
    }
    for (const ObjectPair& pair : touching_) {
      frame.relations[pair] = Relation::kTouching;
    }
    return frame;
  }

  const Vector3d kFar{0.5, 0.5, 0.5};
  const Vector3d kTray{0, 0, 0.02};
  const SceneObjects scene_objects_{Parts(), {"hand"}};
  std::vector<ObjectPair> touching_;
  int64_t utime_ = 0;
  LayerSensor sensor_{scene_objects_, Parts(), {true, true}};
};

TEST_F(LayerSensorTest, TellsInsideFromOnFromAbove) {
  touching_ = {{"block", "tray"}};
  EXPECT_EQ(Next({0, 0, 0.05}, kTray, kFar).PlaceOf("block", "tray"),
            Place::kOn);
  touching_.clear();
  EXPECT_EQ(Next({0, 0, 0.3}, kTray, kFar).PlaceOf("block", "tray"),
            Place::kAbove);
  EXPECT_EQ(Next({0, 0, 0.02}, kTray, kFar).PlaceOf("block", "tray"),
            Place::kInside);
  EXPECT_EQ(Next({0.3, 0, 0.3}, kTray, kFar).PlaceOf("block", "tray"),
            Place::kNone);
  EXPECT_EQ(Next({0, 0, 0.02}, {0, 0, 0.3}, kFar).PlaceOf("tray", "block"),
            Place::kAbove);
}

TEST_F(LayerSensorTest, EverythingIsAboveTheTable) {
  touching_ = {{"block", "table"}};
  const RelationLayers layers = Next({0.4, 0, 0.01}, kTray, kFar);
  EXPECT_EQ(layers.PlaceOf("block", "table"), Place::kOn);
  EXPECT_EQ(layers.PlaceOf("hand", "table"), Place::kAbove);
  EXPECT_EQ(layers.PlaceOf("table", "block"), Place::kCarries);
}

TEST_F(LayerSensorTest, MotionsAreThoseSinceTheKeyFrameBefore) {
  const Vector3d block(0.4, 0, 0.01);
  EXPECT_TRUE(Next(block, kTray, kFar).motions.empty()) << "there is none";
  auto layers = Next(block, kTray, block);
  EXPECT_EQ(layers.MotionOf("hand", "block"), Motion::kGettingCloser);
  EXPECT_EQ(layers.MotionOf("block", "tray"), Motion::kNone);
  const Vector3d lifted(0.4, 0, 0.2);
  layers = Next(lifted, kTray, lifted);
  EXPECT_EQ(layers.MotionOf("hand", "block"), Motion::kMovingTogether);
  EXPECT_EQ(layers.MotionOf("block", "table"), Motion::kMovingApart);
  layers = Next({0, 0, 0.05}, kTray, {0, 0, 0.05});
  EXPECT_EQ(layers.MotionOf("hand", "block"), Motion::kMovingTogether);
  EXPECT_EQ(layers.MotionOf("block", "tray"), Motion::kGettingCloser);
  EXPECT_EQ(layers.MotionOf("block", "table"), Motion::kGettingCloser);
  layers = Next({0, 0, 0.05}, kTray, kFar);
  EXPECT_EQ(layers.MotionOf("hand", "block"), Motion::kMovingApart);
}

TEST_F(LayerSensorTest, NoiseOfAFewMillimetresIsNoMotion) {
  Next({0.4, 0, 0.01}, kTray, kFar);
  EXPECT_TRUE(
      Next({0.406, 0.004, 0.014}, kTray, kFar - Vector3d(0.005, 0, 0.005))
          .motions.empty());
}

TEST_F(LayerSensorTest, AKeyFrameHasTheLayersOfItsOwnTime) {
  Next({0, 0, 0.3}, kTray, kFar);
  KeyFrame frame = FrameNow();
  Next({0.3, 0, 0.3}, kTray, kFar);
  EXPECT_EQ(sensor_.Sense(frame).PlaceOf("block", "tray"), Place::kAbove);
}

TEST_F(LayerSensorTest, ALayerThatIsOffIsEmpty) {
  sensor_ = LayerSensor(scene_objects_, Parts(), {true, false});
  Next({0, 0, 0.3}, kTray, kFar);
  const RelationLayers places = Next({0, 0, 0.1}, kTray, kFar);
  EXPECT_FALSE(places.places.empty());
  EXPECT_TRUE(places.motions.empty());
  sensor_ = LayerSensor(scene_objects_, Parts(), {false, true});
  Next({0, 0, 0.3}, kTray, kFar);
  const RelationLayers motions = Next({0, 0, 0.1}, kTray, kFar);
  EXPECT_TRUE(motions.places.empty());
  EXPECT_FALSE(motions.motions.empty());
}

}  // namespace
}  // namespace cell
