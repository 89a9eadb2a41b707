#include "services/recognizer/recognition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/unit/stage_testing.h"

namespace cell {

using namespace recognizer;
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const std::string kLeft = "hand_left";
const std::string kRight = "hand_right";

class RecognitionTest : public testing::Test {
 protected:
  using Actions = std::vector<RecognisedAction>;

  Actions Observe() { return recognition_.Update(stage_.Frame()); }

  // Picks the part up, lets `move` put it somewhere, lets go of it; returns
  // what is recognised.
  template <class Move>
  Actions Manipulate(const std::string& part, Move move,
                     const std::string& hand = kRight) {
    Observe();
    stage_.Hold(hand, part);
    EXPECT_THAT(Observe(), IsEmpty()) << "at the pick-up of " << part;
    stage_.Lift(part, 0.2);
    EXPECT_THAT(Observe(), IsEmpty()) << "in transit";
    move();
    EXPECT_THAT(Observe(), IsEmpty()) << "not yet let go";
    stage_.LetGo(hand, part);
    return Observe();
  }

  ShippedTask task_;
  Stage stage_{task_};
  Recognition recognition_{task_.scene_objects,
                           task_.parts,
                           task_.MakeLibrary(),
                           task_.MakeSensor(),
                           {}};
};

std::string Shown(const RecognisedAction& action) {
  std::string text = action.direction == ActionDirection::kForward ? "forward "
                     : action.direction == ActionDirection::kReversed
                         ? "reversed "
                         : "unknown";
  text += action.name;
  for (const std::string& argument : action.arguments) text += " " + argument;
  return text;
}

std::vector<std::string> Shown(const std::vector<RecognisedAction>& actions) {
  std::vector<std::string> shown;
  for (const RecognisedAction& action : actions) {
    shown.push_back(Shown(action));
  }
  return shown;
}

TEST_F(RecognitionTest, NamesAnActionWithItsArguments) {
  const auto actions = Manipulate(
      "round_peg_1", [this] { stage_.Seat("round_peg_1", "base.round_2"); });
  EXPECT_THAT(Shown(actions),
              ElementsAre("forward PlaceRoundPeg round_peg_1 base.round_2"));
  EXPECT_EQ(actions[0].part, "round_peg_1");
  EXPECT_THAT(actions[0].hands, ElementsAre(kRight));
  EXPECT_EQ(actions[0].pick_key_frame, 1);
  EXPECT_EQ(actions[0].pick_utime, 500'000);
  EXPECT_EQ(actions[0].place_key_frame, 4);
  EXPECT_EQ(actions[0].place_utime, 2'000'000);
}

TEST_F(RecognitionTest, DistinguishesPartsAndSitesThatLookAlike) {
  for (const auto& [part, site] : {std::pair{"square_peg_2", "base.square_1"},
                                   {"square_peg_1", "base.square_2"}}) {
    EXPECT_THAT(
        Shown(Manipulate(part, [&, p = part, s = site] { stage_.Seat(p, s); })),
        ElementsAre(std::string("forward PlaceSquarePeg ") + part + " " +
                    site));
  }
}

TEST_F(RecognitionTest, RecognisesAllStepsOfAnAssembly) {
  std::vector<std::string> all;
  for (const auto& [part, site] : {std::pair{"shaft", "base.shaft"},
                                   {"round_peg_2", "base.round_1"},
                                   {"square_peg_1", "base.square_1"},
                                   {"pendulum", "base.pendulum"},
                                   {"square_peg_2", "base.square_2"},
                                   {"separator", "base.separator"},
                                   {"head", "pendulum.head"},
                                   {"round_peg_1", "base.round_2"},
                                   {"face_plate", "base.face_plate"}}) {
    const auto actions =
        Manipulate(part, [&, p = part, s = site] { stage_.Seat(p, s); });
    ASSERT_THAT(actions, SizeIs(1)) << part;
    all.push_back(Shown(actions[0]));
  }
  EXPECT_THAT(
      all,
      ElementsAre("forward PlaceRoundPeg shaft base.shaft",
                  "forward PlaceRoundPeg round_peg_2 base.round_1",
                  "forward PlaceSquarePeg square_peg_1 base.square_1",
                  "forward PlacePendulum pendulum",
                  "forward PlaceSquarePeg square_peg_2 base.square_2",
                  "forward PlaceSeparator separator", "forward ScrewHead head",
                  "forward PlaceRoundPeg round_peg_1 base.round_2",
                  "forward PlaceFacePlate face_plate"));
}

TEST_F(RecognitionTest, ReadsATakeBackAsTheActionReversed) {
  stage_.Seat("pendulum", "base.pendulum");
  EXPECT_THAT(Shown(Manipulate(
                  "pendulum", [this] { stage_.StandAt("pendulum", 0, -0.4); })),
              ElementsAre("reversed PlacePendulum pendulum"));
}

// Also if it has left its site before the pick-up's key frame is confirmed.
TEST_F(RecognitionTest, ReadsATakeBackInOneGoAsTheActionReversed) {
  stage_.Seat("shaft", "base.shaft");
  Observe();
  stage_.Lift("shaft", 0.1);
  stage_.Hold(kRight, "shaft");
  Observe();
  stage_.StandAt("shaft", 0, -0.4);
  stage_.LetGo(kRight, "shaft");
  EXPECT_THAT(Shown(Observe()),
              ElementsAre("reversed PlaceRoundPeg shaft base.shaft"));
}

TEST_F(RecognitionTest, ReadsAMoveFromSiteToSiteAsUndoneThenDone) {
  stage_.Seat("round_peg_1", "base.round_1");
  EXPECT_THAT(
      Shown(Manipulate("round_peg_1",
                       [this] { stage_.Seat("round_peg_1", "base.round_2"); })),
      ElementsAre("reversed PlaceRoundPeg round_peg_1 base.round_1",
                  "forward PlaceRoundPeg round_peg_1 base.round_2"));
}

TEST_F(RecognitionTest, ReportsAMoveThatNoActionExplainsAsUnknown) {
  const auto actions = Manipulate(
      "separator", [this] { stage_.StandAt("separator", 0.3, -0.3); });
  EXPECT_THAT(Shown(actions), ElementsAre("unknown"));
  EXPECT_EQ(actions[0].part, "separator");
}

TEST_F(RecognitionTest, AlmostSeatedIsUnknown) {
  const Eigen::Isometry3d too_high(Eigen::Translation3d(0, 0, 0.0012));
  EXPECT_THAT(
      Shown(Manipulate("shaft",
                       [&] { stage_.Seat("shaft", "base.shaft", too_high); })),
      ElementsAre("unknown"));
}

TEST_F(RecognitionTest, ABrushIsNoAction) {
  stage_.Seat("round_peg_1", "base.round_1");
  for (const char* part : {"round_peg_1", "head"}) {
    Observe();
    stage_.Hold(kLeft, part);
    EXPECT_THAT(Observe(), IsEmpty());
    stage_.Lift(part, 0.0005);
    stage_.LetGo(kLeft, part);
    EXPECT_THAT(Observe(), IsEmpty()) << part;
  }
}

TEST_F(RecognitionTest, PuttingAPartBackWhereItWasIsNoAction) {
  stage_.Seat("round_peg_1", "base.round_1");
  EXPECT_THAT(
      Manipulate("round_peg_1",
                 [this] { stage_.Seat("round_peg_1", "base.round_1"); }),
      IsEmpty());
}

TEST_F(RecognitionTest, ATurnThatCannotBeSeenIsNoMove) {
  const Eigen::Isometry3d X_WO = stage_.PoseOf("round_peg_1");
  const Eigen::Isometry3d turn(
      Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitZ()));
  EXPECT_THAT(Manipulate("round_peg_1",
                         [&] { stage_.Put("round_peg_1", X_WO * turn); }),
              IsEmpty());
}

TEST_F(RecognitionTest, AHandOverIsOneManipulationByBothHands) {
  Observe();
  stage_.Hold(kRight, "head");
  Observe();
  stage_.Lift("head", 0.3);
  stage_.Hold(kLeft, "head");
  Observe();
  stage_.LetGo(kRight, "head");
  EXPECT_THAT(Observe(), IsEmpty());
  stage_.StandAt("head", 0.3, -0.3);
  stage_.LetGo(kLeft, "head");
  const auto actions = Observe();
  ASSERT_THAT(Shown(actions), ElementsAre("unknown"));
  EXPECT_THAT(actions[0].hands, ElementsAre(kLeft, kRight));
}

TEST_F(RecognitionTest, TwoHandsWorkAtTheSameTime) {
  Observe();
  stage_.Hold(kRight, "round_peg_1");
  Observe();
  stage_.Hold(kLeft, "square_peg_1");
  stage_.Seat("round_peg_1", "base.round_1");
  Observe();
  stage_.LetGo(kRight, "round_peg_1");
  EXPECT_THAT(Shown(Observe()),
              ElementsAre("forward PlaceRoundPeg round_peg_1 base.round_1"));
  stage_.Seat("square_peg_1", "base.square_1");
  stage_.LetGo(kLeft, "square_peg_1");
  EXPECT_THAT(Shown(Observe()),
              ElementsAre("forward PlaceSquarePeg square_peg_1 base.square_1"));
}

TEST_F(RecognitionTest, RaisingIsAnActionAndLayingDownItsReverse) {
  stage_.LieAt("square_peg_1", 0.1, -0.4);
  EXPECT_THAT(
      Shown(Manipulate("square_peg_1",
                       [this] { stage_.StandAt("square_peg_1", 0.1, -0.4); })),
      ElementsAre("forward Raise square_peg_1"));
  EXPECT_THAT(
      Shown(Manipulate("square_peg_1",
                       [this] { stage_.LieAt("square_peg_1", 0.1, -0.4); })),
      ElementsAre("reversed Raise square_peg_1"));
}

TEST_F(RecognitionTest, ALyingPartPutToItsSiteAtOnceIsNotRaised) {
  stage_.LieAt("square_peg_1", 0.1, -0.4);
  EXPECT_THAT(Shown(Manipulate(
                  "square_peg_1",
                  [this] { stage_.Seat("square_peg_1", "base.square_2"); })),
              ElementsAre("forward PlaceSquarePeg square_peg_1 base.square_2"));
}

// The head is screwed to the pendulum; both are touched, the pendulum is moved.
TEST_F(RecognitionTest, APassengerIsNoManipulation) {
  stage_.Seat("head", "pendulum.head");
  for (const bool passenger_is_let_go_first : {true, false}) {
    const std::string first = passenger_is_let_go_first ? "head" : "pendulum";
    const std::string second = passenger_is_let_go_first ? "pendulum" : "head";
    Observe();
    stage_.Hold(kRight, "pendulum");
    stage_.Hold(kRight, "head");
    Observe();
    stage_.Seat("pendulum", "base.pendulum");
    stage_.Seat("head", "pendulum.head");
    stage_.LetGo(kRight, first);
    auto actions = Observe();
    stage_.LetGo(kRight, second);
    for (const auto& action : Observe()) actions.push_back(action);
    EXPECT_THAT(Shown(actions), ElementsAre("forward PlacePendulum pendulum"));
    stage_.StandAt("pendulum", 0, -0.4);
    stage_.Seat("head", "pendulum.head");
    Observe();
  }
}

TEST_F(RecognitionTest, OfTwoPartsMovedAsOneOnlyOneIsUnknown) {
  for (const bool at_once : {true, false}) {
    stage_.StandAt("pendulum", 0, -0.4);
    stage_.Seat("head", "pendulum.head");
    Observe();
    stage_.Hold(kRight, "pendulum");
    if (!at_once) Observe();
    stage_.Hold(kRight, "head");
    Observe();
    stage_.StandAt("pendulum", 0.3, -0.5);
    stage_.Seat("head", "pendulum.head");
    stage_.LetGo(kRight, "pendulum");
    stage_.LetGo(kRight, "head");
    EXPECT_THAT(Shown(Observe()), ElementsAre("unknown")) << at_once;
  }
}

// Of a restarted service: the first frame shows the part in the hand.
TEST_F(RecognitionTest, WhatItJoinsInTheMiddleOfIsCompletedByTheStream) {
  stage_.Hold(kRight, "round_peg_1");
  stage_.Lift("round_peg_1", 0.2);
  EXPECT_THAT(Observe(), IsEmpty());
  stage_.Seat("round_peg_1", "base.round_1");
  EXPECT_THAT(Observe(), IsEmpty());
  stage_.LetGo(kRight, "round_peg_1");
  EXPECT_THAT(Shown(Observe()),
              ElementsAre("forward PlaceRoundPeg round_peg_1 base.round_1"));
}

TEST_F(RecognitionTest, WhatItDidNotSeeBeginIsNotGivenAName) {
  stage_.Hold(kRight, "round_peg_1");  // out of base.round_1, before it joins
  stage_.Lift("round_peg_1", 0.2);
  stage_.Hold(kLeft, "head");  // in its place already
  stage_.Seat("head", "pendulum.head");
  EXPECT_THAT(Observe(), IsEmpty());
  stage_.LetGo(kLeft, "head");
  EXPECT_THAT(Observe(), IsEmpty());
  stage_.StandAt("round_peg_1", 0.3, -0.3);
  EXPECT_THAT(Observe(), IsEmpty());
  stage_.LetGo(kRight, "round_peg_1");
  EXPECT_THAT(Shown(Observe()), ElementsAre("unknown"));
}

TEST_F(RecognitionTest, OneHandPlacesWhileTheOtherTakesBack) {
  stage_.Seat("pendulum", "base.pendulum");
  Observe();
  stage_.Hold(kRight, "round_peg_1");
  Observe();
  stage_.Hold(kLeft, "pendulum");
  stage_.Lift("round_peg_1", 0.2);
  Observe();
  stage_.StandAt("pendulum", 0, -0.4);
  stage_.Seat("round_peg_1", "base.round_1");
  Observe();
  stage_.LetGo(kRight, "round_peg_1");
  stage_.LetGo(kLeft, "pendulum");
  const auto actions = Observe();
  EXPECT_THAT(Shown(actions),
              testing::UnorderedElementsAre(
                  "forward PlaceRoundPeg round_peg_1 base.round_1",
                  "reversed PlacePendulum pendulum"));
  for (const RecognisedAction& action : actions) {
    EXPECT_THAT(action.hands, SizeIs(1)) << action.part;
  }
}

TEST_F(RecognitionTest, IsSureOfWhatAgreesAloneAndOfWhatAgreesWithNothing) {
  const auto named =
      Manipulate("shaft", [this] { stage_.Seat("shaft", "base.shaft"); });
  ASSERT_THAT(named, SizeIs(1));
  EXPECT_DOUBLE_EQ(named[0].confidence, 1);
  const auto unknown = Manipulate(
      "separator", [this] { stage_.StandAt("separator", 0.3, -0.3); });
  ASSERT_THAT(unknown, SizeIs(1));
  EXPECT_DOUBLE_EQ(unknown[0].confidence, 1);
}

TEST_F(RecognitionTest, HypothesesArePrunedAtThePickUp) {
  stage_.Seat("round_peg_1", "base.round_1");
  Observe();
  stage_.Hold(kRight, "round_peg_1");
  Observe();
  const Manipulation& held = recognition_.manipulations().at("round_peg_1");
  std::vector<std::string> alive;
  for (const auto& hypothesis : held.hypotheses()) {
    alive.push_back((hypothesis.direction == ActionDirection::kForward
                         ? "forward "
                         : "reversed ") +
                    hypothesis.roles.back());
  }
  EXPECT_THAT(alive,
              ElementsAre("reversed base.round_1", "reversed round_peg_1",
                          "forward base.round_2"));
}

// A model that knows nothing but the chain: how often a hand took the part.
class TouchCount final : public SecModel {
 public:
  TouchCount(std::string action, size_t num_columns, double agreement)
      : action_(std::move(action)),
        num_columns_(num_columns),
        agreement_(agreement) {}

  const std::string& action() const override { return action_; }
  std::vector<Roles> RolesAtPickUp(const std::string& part, const SensedFrame&,
                                   ActionDirection direction) const override {
    if (direction == ActionDirection::kReversed) return {};
    return {{part}};
  }
  double Agreement(const ObservedManipulation& manipulation, const Roles& roles,
                   ActionDirection) const override {
    EXPECT_EQ(roles, Roles{manipulation.part});
    EXPECT_EQ(
        manipulation.chain.num_columns(),
        manipulation.after.frame.index - manipulation.before.frame.index + 1);
    const EventChain of_hand = manipulation.chain.RowsOf(kRight)
                                   .RowsOf(manipulation.part)
                                   .DistinctColumns();
    return of_hand.num_columns() == num_columns_ ? agreement_ : 0;
  }

 private:
  std::string action_;
  size_t num_columns_;
  double agreement_;
};

class CountingLibrary final : public SecLibrary {
 public:
  const Models& models() const override { return models_; }
  double threshold() const override { return 0.5; }

 private:
  Models models_ = {std::make_shared<TouchCount>("Touched", 3, 0.6),
                    std::make_shared<TouchCount>("Moved", 3, 0.8),
                    std::make_shared<TouchCount>("Faint", 3, 0.4),
                    std::make_shared<TouchCount>("Never", 7, 1.0)};
};

TEST_F(RecognitionTest, TakesTheBestOfAnyLibraryAboveItsThreshold) {
  recognition_.Use(std::make_shared<const CountingLibrary>());
  const auto actions =
      Manipulate("head", [this] { stage_.StandAt("head", 0.3, -0.2); });
  EXPECT_THAT(Shown(actions), ElementsAre("forward Moved head"));
  EXPECT_NEAR(actions[0].confidence, (0.8 + (0.8 - 0.6)) / 2, 1e-12);
}

TEST_F(RecognitionTest, WhatIsInAHandKeepsTheModelsOfItsPickUp) {
  Observe();
  stage_.Hold(kRight, "round_peg_1");
  Observe();
  recognition_.Use(std::make_shared<const CountingLibrary>());
  stage_.Seat("round_peg_1", "base.round_1");
  stage_.LetGo(kRight, "round_peg_1");
  EXPECT_THAT(Shown(Observe()),
              ElementsAre("forward PlaceRoundPeg round_peg_1 base.round_1"));
}

TEST_F(RecognitionTest, APartThatIsGoneWhenItIsLetGoIsNotReported) {
  Observe();
  stage_.Hold(kRight, "head");
  Observe();
  stage_.Remove("head");
  stage_.LetGo(kRight, "head");
  EXPECT_THAT(Observe(), IsEmpty());
  EXPECT_THAT(recognition_.manipulations(), IsEmpty());
}

}  // namespace
}  // namespace cell
