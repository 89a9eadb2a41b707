#include "services/cell/explaining/action_explainer.h"

#include <gmock/gmock.h>

#include <memory>
#include <string>
#include <vector>

#include "cell/episode_t.hpp"
#include "common/bus/bus.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class ActionExplainerTest : public testing::Test {
 protected:
  void Observe(const KeyFrame& frame) {
    Message message{};
    message.channel = "KEY_FRAME";
    message.bytes =
        std::make_shared<const Bytes>(Bus::Encode(KeyFrameToMessage(frame)));
    explainer_.Put(message);
  }
  template <class Move>
  void Manipulate(const std::string& part, Move move) {
    stage_.Manipulate(part, move,
                      [this](const KeyFrame& frame) { Observe(frame); });
  }

  ShippedTask task_;
  Stage stage_{task_};
  ActionExplainer explainer_{
      recognizer::Recognizer::Params::Load(ShippedDeployment())};
};

TEST_F(ActionExplainerTest, SaysWhatHeldOfTheModelAndWhatTheNextBestLacked) {
  Manipulate("round_peg_1",
             [this] { stage_.Seat("round_peg_1", "base.round_1"); });
  ASSERT_THAT(explainer_.explanations(), SizeIs(1));
  const Explanation& why = explainer_.explanations()[0];
  EXPECT_EQ(why.utime, 2'000'000);
  EXPECT_THAT(why.what, HasSubstr("round_peg_1 was moved: "
                                  "PlaceRoundPeg(round_peg_1, base.round_1), "
                                  "confidence 1.00"));
  EXPECT_THAT(why.reasons,
              Contains(HasSubstr("hand_right held it from 0.50 s (key frame 1) "
                                 "to 2.00 s (key frame 4)")));
  EXPECT_THAT(why.reasons,
              Contains("chosen: PlaceRoundPeg(round_peg_1, base.round_1), "
                       "agreement 1.00"));
  EXPECT_THAT(why.reasons, Contains(HasSubstr("held afterwards: ")));
  EXPECT_THAT(why.reasons,
              Contains(HasSubstr("next best: PlaceRoundPeg(round_peg_1, "
                                 "base.round_2), agreement 0.00")));
  EXPECT_THAT(why.reasons,
              Contains(HasSubstr("must hold afterwards, but did not: "
                                 "PegInHole(round_peg_1, base.round_2)")));
}

TEST_F(ActionExplainerTest, SaysWhatAnUnknownManipulationLacksOfTheNearest) {
  const Eigen::Isometry3d too_high(Eigen::Translation3d(0, 0, 0.0012));
  Manipulate("shaft", [&] { stage_.Seat("shaft", "base.shaft", too_high); });
  ASSERT_THAT(explainer_.explanations(), SizeIs(1));
  const Explanation& why = explainer_.explanations()[0];
  EXPECT_THAT(why.what, HasSubstr("shaft was moved: an unknown manipulation"));
  EXPECT_THAT(why.reasons, Contains(HasSubstr("no model reaches")));
  EXPECT_THAT(why.reasons,
              Contains("nearest: PlaceRoundPeg(shaft, base.shaft), agreement "
                       "0.00"));
  EXPECT_THAT(why.reasons,
              Contains(HasSubstr("must hold afterwards, but did not: "
                                 "PegInHole(shaft, base.shaft)")));
  EXPECT_THAT(why.reasons, Not(Contains(HasSubstr("chosen"))));
}

TEST_F(ActionExplainerTest, AnEpisodeBeginsWithoutWhatWasInHand) {
  Observe(stage_.Frame());
  stage_.Hold("hand_right", "shaft");
  Observe(stage_.Frame());
  episode_t episode{};
  episode.phase = episode_t::START;
  Message message{};
  message.channel = "EPISODE";
  message.bytes = std::make_shared<const Bytes>(Bus::Encode(episode));
  explainer_.Put(message);
  stage_.LetGo("hand_right", "shaft");
  stage_.StandAt("shaft", 0.3, -0.3);
  Observe(stage_.Frame());
  EXPECT_THAT(explainer_.explanations(), IsEmpty());
}

TEST_F(ActionExplainerTest, WhatIsOfAMomentIsGivenForIt) {
  Manipulate("round_peg_1",
             [this] { stage_.Seat("round_peg_1", "base.round_1"); });
  EXPECT_THAT(explainer_.Utimes(), testing::ElementsAre(2'000'000));
  EXPECT_THAT(explainer_.At(2'000'000), SizeIs(1));
  EXPECT_THAT(explainer_.At(2'000'001), IsEmpty());
}

TEST(Explanations, TheNearestIsGiven) {
  EXPECT_FALSE(NearestTo(0, {}));
  const std::vector<int64_t> all = {10, 20, 40};
  EXPECT_EQ(NearestTo(0, all), 10);
  EXPECT_EQ(NearestTo(15, all), 10);
  EXPECT_EQ(NearestTo(29, all), 20);
  EXPECT_EQ(NearestTo(31, all), 40);
}

}  // namespace
}  // namespace cell
