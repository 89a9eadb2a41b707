#include "services/sec_builder/proximity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "services/tracker/ideal_tracker.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace sec_builder;
using namespace tracker;
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using testing::UnorderedElementsAre;

class ProximityTest : public testing::Test {
 protected:
  Tracks Seen() const {
    TruthPoses truth;
    for (const Track& track : stage_.AllTracked().tracks) {
      truth.poses[track.name] = track.X_WO;
    }
    for (const auto& [hand, X_WG] : hands_) {
      for (const auto& known : task_.layout.AllHands()) {
        if (known.name != hand) continue;
        AddHand(*known.type, hand, X_WG, opening_, truth);
      }
    }
    return IdealTracker(task_.scene_objects, task_.layout, {}).Update(truth);
  }

  std::set<std::string> TouchedBy(const std::string& name) const {
    std::set<std::string> touched;
    for (const auto& [pair, proximity] : sensor_.Measure(Seen())) {
      if (proximity.distance >= 0.004) continue;
      if (pair.first == name) touched.insert(pair.second);
      if (pair.second == name) touched.insert(pair.first);
    }
    return touched;
  }

  ShippedTask task_;
  Stage stage_{task_};
  std::map<std::string, Isometry3d> hands_ = {
      {"hand_left", Isometry3d(Translation3d(-0.44, -0.3, 0.4))},
      {"hand_right", Isometry3d(Translation3d(0.62, -0.3, 0.4))},
      {"gripper_left", Isometry3d(Translation3d(-0.3, 0.3, 0.5))},
      {"gripper_right", Isometry3d(Translation3d(0.3, 0.3, 0.5))}};
  double opening_ = 0.1;
  ProximitySensor sensor_{task_.scene_objects, task_.parts, {}};
};

TEST_F(ProximityTest, MeasuresAllPairs) {
  const size_t n = task_.scene_objects.names().size();
  EXPECT_EQ(sensor_.Measure(Seen()).size(), n * (n - 1) / 2);
}

TEST_F(ProximityTest, AtFirstPartsTouchTheTableAlone) {
  for (const std::string& part : task_.scene_objects.parts()) {
    if (part == "base") {
      EXPECT_TRUE(TouchedBy(part).empty());
    } else {
      EXPECT_THAT(TouchedBy(part), UnorderedElementsAre("table")) << part;
    }
  }
  EXPECT_TRUE(TouchedBy("hand_left").empty());
  EXPECT_TRUE(TouchedBy("hand_right").empty());
}

TEST_F(ProximityTest, InTheAssemblyNeighboursTouch) {
  stage_.SeatAll();
  EXPECT_THAT(TouchedBy("base"),
              UnorderedElementsAre("shaft", "round_peg_1", "round_peg_2",
                                   "square_peg_1", "square_peg_2", "separator",
                                   "pendulum"));
  EXPECT_THAT(TouchedBy("head"), UnorderedElementsAre("pendulum"));
  EXPECT_THAT(TouchedBy("separator"),
              UnorderedElementsAre("base", "square_peg_1", "square_peg_2",
                                   "pendulum", "face_plate"));
  EXPECT_TRUE(TouchedBy("table").empty());
}

TEST_F(ProximityTest, AGraspTouchesThePartOnceTheFingersClose) {
  const Part& part = *task_.parts.Find("square_peg_1");
  hands_["hand_left"] = stage_.PoseOf("square_peg_1") * part.grasps[0].X_OG;
  opening_ = part.grasps[0].width + 0.024;
  EXPECT_TRUE(TouchedBy("hand_left").empty());
  opening_ = part.grasps[0].width;
  EXPECT_THAT(TouchedBy("hand_left"), UnorderedElementsAre("square_peg_1"));
}

TEST_F(ProximityTest, HandsTouchEachOtherAndTheTable) {
  hands_["hand_left"] = Isometry3d(Translation3d(0.5, 0, 0.005));
  hands_["hand_right"] = Isometry3d(Translation3d(0.5, 0.053, 0.005));
  EXPECT_THAT(TouchedBy("hand_left"),
              UnorderedElementsAre("hand_right", "table"));
}

TEST_F(ProximityTest, WhatIsNotTrackedIsNotMeasured) {
  Tracks tracks = Seen();
  tracks.tracks[0].state = Track::State::kFrozen;
  const size_t n = task_.scene_objects.names().size() - 1;
  EXPECT_EQ(sensor_.Measure(tracks).size(), n * (n - 1) / 2);
}

TEST_F(ProximityTest, NoPartOfTheAssemblyContainsAnother) {
  stage_.SeatAll();
  for (const auto& [pair, proximity] : sensor_.Measure(Seen())) {
    EXPECT_LT(proximity.slack, 0) << pair.first << " " << pair.second;
  }
}

}  // namespace
}  // namespace cell
