#include "services/sec_builder/key_frame_emulation.h"

#include <gmock/gmock.h>

#include "tests/unit/stage_testing.h"

namespace cell {

using namespace sec_builder;
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr int64_t kStep = 500'000;  // [us] between key frames of a stage

class KeyFrameEmulationTest : public testing::Test {
 protected:
  /// What becomes of a hand that takes the shaft and lets go of it, so often.
  std::vector<KeyFrame> Emulate(const KeyFrameEmulation::Params& params,
                                int num_times = 1) {
    KeyFrameEmulation emulation(task_.scene_objects, params);
    Stage stage(task_);
    std::vector<KeyFrame> all;
    num_true_ = 0;
    const auto see = [&] {
      const KeyFrame frame = stage.Frame();
      ++num_true_;
      for (KeyFrame& f : emulation.Update(frame.utime, {frame})) {
        all.push_back(std::move(f));
      }
    };
    see();
    for (int i = 0; i < num_times; ++i) {
      stage.Hold("hand_right", "shaft");
      see();
      stage.LetGo("hand_right", "shaft");
      see();
    }
    return all;
  }
  static bool IsHeld(const KeyFrame& frame) {
    return Touch(frame.relations, "hand_right", "shaft");
  }
  const ShippedTask task_;
  int num_true_ = 0;
};

TEST_F(KeyFrameEmulationTest, SwitchedOffItGivesTheTruth) {
  const auto frames = Emulate({}, 3);
  ASSERT_THAT(frames, SizeIs(7));
  for (size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].index, static_cast<int64_t>(i));
    EXPECT_EQ(IsHeld(frames[i]), i % 2 == 1);
  }
}

TEST_F(KeyFrameEmulationTest, WhatIsMissedIsNoKeyFrame) {
  EXPECT_THAT(Emulate({.missed = 1}, 3), SizeIs(1));
  const auto frames = Emulate({.missed = 0.3}, 200);
  EXPECT_LT(frames.size(), static_cast<size_t>(num_true_));
  EXPECT_GT(frames.size(), static_cast<size_t>(num_true_) / 4);
  for (size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].index, static_cast<int64_t>(i));
    EXPECT_EQ(IsHeld(frames[i]), i % 2 == 1) << "a key frame changes something";
  }
}

TEST_F(KeyFrameEmulationTest, AWrongPairSharesAnObjectAndIsCorrectedNext) {
  KeyFrameEmulation emulation(task_.scene_objects, {.wrong = 1});
  Stage stage(task_);
  const auto see = [&] {
    const KeyFrame frame = stage.Frame();
    return emulation.Update(frame.utime, {frame});
  };
  const TouchGraph at_first = see().at(0).relations;
  stage.Hold("hand_right", "shaft");
  const auto wrong = see();
  ASSERT_THAT(wrong, SizeIs(1));
  EXPECT_FALSE(IsHeld(wrong[0]));
  for (const auto& [pair, relation] : wrong[0].relations) {
    if (relation == at_first.at(pair)) continue;
    EXPECT_TRUE(pair.first == "hand_right" || pair.first == "shaft" ||
                pair.second == "hand_right" || pair.second == "shaft");
  }
  const auto corrected = see();
  ASSERT_THAT(corrected, SizeIs(1));
  EXPECT_EQ(corrected[0].relations, at_first) << "but the change is missed";
}

TEST_F(KeyFrameEmulationTest, ALateKeyFrameKeepsItsTimeAndHoldsUpThoseBehind) {
  KeyFrameEmulation emulation(task_.scene_objects,
                              {.late = 1, .late_us = 2 * kStep});
  Stage stage(task_);
  const KeyFrame first = stage.Frame();
  EXPECT_THAT(emulation.Update(first.utime, {first}), IsEmpty());
  EXPECT_THAT(emulation.Update(first.utime + 2 * kStep - 1, {}), IsEmpty());
  const auto known = emulation.Update(first.utime + 2 * kStep, {});
  ASSERT_THAT(known, SizeIs(1));
  EXPECT_EQ(known[0].utime, first.utime);
}

TEST_F(KeyFrameEmulationTest, TheSameSeedGivesTheSameErrors) {
  const KeyFrameEmulation::Params params{
      .missed = 0.2, .wrong = 0.2, .late = 0.2, .late_us = kStep, .seed = 5};
  const auto relations_of = [&](uint64_t seed) {
    std::vector<TouchGraph> graphs;
    KeyFrameEmulation::Params seeded = params;
    seeded.seed = seed;
    for (const KeyFrame& frame : Emulate(seeded, 30)) {
      graphs.push_back(frame.relations);
    }
    return graphs;
  };
  EXPECT_EQ(relations_of(5), relations_of(5));
  EXPECT_NE(relations_of(5), relations_of(6));
}

TEST_F(KeyFrameEmulationTest, EachEpisodeHasErrorsOfItsOwn) {
  KeyFrameEmulation emulation(task_.scene_objects, {.missed = 0.5});
  const auto sizes_of = [&](uint64_t episode_seed) {
    emulation.Reset(episode_seed);
    Stage stage(task_);
    std::vector<size_t> sizes;
    for (int i = 0; i < 40; ++i) {
      if (i % 2 == 1) {
        stage.Hold("hand_right", "shaft");
      } else {
        stage.LetGo("hand_right", "shaft");
      }
      const KeyFrame frame = stage.Frame();
      sizes.push_back(emulation.Update(frame.utime, {frame}).size());
    }
    return sizes;
  };
  const auto first = sizes_of(1);
  EXPECT_NE(sizes_of(2), first);
  EXPECT_EQ(sizes_of(1), first);
}

// A receiver takes only frames whose relative poses are of pairs that touch.
TEST_F(KeyFrameEmulationTest, EveryKeyFrameIsAccepted) {
  for (const KeyFrame& frame :
       Emulate({.missed = 0.3, .wrong = 0.3, .late = 0.3}, 30)) {
    EXPECT_TRUE(
        KeyFrameFromMessage(KeyFrameToMessage(frame), task_.scene_objects));
  }
}

}  // namespace
}  // namespace cell
