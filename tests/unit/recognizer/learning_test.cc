#include "services/recognizer/learning.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>

#include "common/actions/sec_models.h"
#include "services/recognizer/recognition.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace recognizer;
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class LearningTest : public testing::Test {
 protected:
  LearningTest() {
    recognition_.SetObserver([this](const auto& manipulation, const auto&) {
      shown_ = learning_->OnManipulation(manipulation, "test 1", actions_);
    });
  }

  /// What is recognised.
  std::vector<RecognisedAction> Manipulate(const std::string& part,
                                           const std::function<void()>& move) {
    Observe();
    stage_.Hold("hand_right", part);
    Observe();
    move();
    Observe();
    stage_.LetGo("hand_right", part);
    return Observe();
  }
  std::vector<RecognisedAction> Seat(const std::string& part,
                                     const std::string& site) {
    return Manipulate(part, [&] { stage_.Seat(part, site); });
  }
  /// What the library would do.
  std::vector<ActionRecord> Store() {
    auto records = learning_->TakeChanges(actions_);
    for (const ActionRecord& record : records) {
      const auto update = actions_.Apply(record);
      EXPECT_TRUE(update) << update.reason();
      recognition_.Use(MakeSecLibrary(actions_));
      learning_->OnRecord(record.name, actions_);
    }
    return records;
  }

  GenericSkill Hands() const {
    return {task_.domain.vocabulary(), task_.geometries, task_.layout};
  }
  static std::vector<ActionModel> WithoutSec(std::vector<ActionModel> models) {
    for (ActionModel& model : models) model.sec.reset();
    return models;
  }

  const ShippedTask task_;
  ActionModels actions_{task_.domain, task_.parts, WithoutSec(task_.actions)};
  std::optional<Learning> learning_{std::in_place, actions_, Hands()};
  std::optional<Learning::Shown> shown_;  // at last
  Stage stage_{task_};
  Recognition recognition_{task_.scene_objects,
                           task_.parts,
                           MakeSecLibrary(actions_),
                           task_.MakeSensor(),
                           {}};

 private:
  std::vector<RecognisedAction> Observe() {
    return recognition_.Update(stage_.Frame());
  }
};

TEST_F(LearningTest, WhatIsShownForTheFirstTimeBecomesARecord) {
  const auto actions = Seat("round_peg_1", "base.round_1");
  ASSERT_THAT(actions, SizeIs(1));
  EXPECT_EQ(actions[0].direction, ActionDirection::kUnknown);
  const auto records = Store();
  ASSERT_THAT(records, SizeIs(1));
  EXPECT_EQ(records[0].name, "Action1");
  EXPECT_EQ(records[0].version, 1);
  EXPECT_THAT(records[0].agents, testing::ElementsAre("person", "robot"));
  EXPECT_THAT(records[0].rules, HasSubstr("PegInHole(X, Y)"));
  EXPECT_THAT(Store(), IsEmpty());

  const auto again = Seat("round_peg_2", "base.round_2");
  ASSERT_THAT(again, SizeIs(1));
  EXPECT_EQ(again[0].name, "Action1");
  EXPECT_THAT(again[0].arguments,
              testing::ElementsAre("round_peg_2", "base.round_2"));
  EXPECT_GT(again[0].confidence, 0.9);
}

TEST_F(LearningTest, SaysWhichRecordAnUnknownManipulationHasOpened) {
  Seat("round_peg_1", "base.round_1");
  ASSERT_TRUE(shown_);
  EXPECT_EQ(shown_->action, "Action1");
  EXPECT_THAT(shown_->arguments,
              testing::ElementsAre("round_peg_1", "base.round_1"));
}

TEST_F(LearningTest, ArmsInsertWhatWasSeatedAtTheSiteThatAPredicateNames) {
  Seat("round_peg_1", "base.round_1");
  const auto at_argument = Store();
  ASSERT_THAT(at_argument, SizeIs(1));
  EXPECT_THAT(at_argument[0].skill, HasSubstr("name: insert"));
  EXPECT_THAT(at_argument[0].skill, HasSubstr("site: Y"));
  EXPECT_THAT(at_argument[0].skill, HasSubstr("arm: right"));
  Seat("separator", "base.separator");
  const auto at_fixed = Store();
  ASSERT_THAT(at_fixed, SizeIs(1));
  EXPECT_THAT(at_fixed[0].skill, HasSubstr("site: base.separator"));
  EXPECT_EQ(at_fixed[0].skill_settings, "insertion");
}

TEST_F(LearningTest, AFirstShowingThatIsARemovalShowsWhatArmsInsert) {
  stage_.Seat("round_peg_1", "base.round_1");
  Manipulate("round_peg_1", [&] { stage_.StandAt("round_peg_1", 0.1, -0.4); });
  EXPECT_FALSE(shown_) << "it undoes the action that it teaches";
  const auto records = Store();
  ASSERT_THAT(records, SizeIs(1));
  EXPECT_THAT(records[0].agents, testing::ElementsAre("person", "robot"));
  EXPECT_THAT(records[0].skill, HasSubstr("site: Y"));
  const auto placed = Seat("round_peg_2", "base.round_2");
  ASSERT_THAT(placed, SizeIs(1));
  EXPECT_EQ(placed[0].name, "Action1");
  EXPECT_EQ(placed[0].direction, ActionDirection::kForward);
  ASSERT_TRUE(shown_);
  EXPECT_THAT(shown_->arguments,
              testing::ElementsAre("round_peg_2", "base.round_2"));
  const auto removed = Manipulate(
      "round_peg_2", [&] { stage_.StandAt("round_peg_2", 0.2, -0.4); });
  ASSERT_THAT(removed, SizeIs(1));
  EXPECT_EQ(removed[0].direction, ActionDirection::kReversed);
}

TEST_F(LearningTest, TellsTheObjectsInTheOrderOfTheRecord) {
  Seat("round_peg_1", "base.round_1");
  Store();
  ActionModel turned = actions_.models().back();
  ASSERT_EQ(turned.action.name, "Action1");
  std::ranges::reverse(turned.action.arguments);
  turned.action.rules.clear();
  turned.sec = *FitToArguments(*turned.sec, turned.action.arguments,
                               task_.domain.vocabulary().types());
  const ActionModels only_turned(task_.domain, task_.parts, {turned});
  Learning learning(only_turned, Hands());
  recognition_.SetObserver([&](const auto& manipulation, const auto&) {
    shown_ = learning.OnManipulation(manipulation, "test 2", only_turned);
  });
  Seat("round_peg_2", "base.round_2");
  ASSERT_TRUE(shown_);
  EXPECT_THAT(shown_->arguments,
              testing::ElementsAre("base.round_2", "round_peg_2"));
}

TEST_F(LearningTest, WhatIsTakenBackTellsNoRecord) {
  Seat("round_peg_1", "base.round_1");
  Manipulate("round_peg_1", [&] { stage_.StandAt("round_peg_1", 0.1, -0.4); });
  EXPECT_FALSE(shown_);
}

TEST_F(LearningTest, WhatHasToDoWithNoSiteIsLeftToPeople) {
  Manipulate("round_peg_1", [&] { stage_.LieAt("round_peg_1", 0.1, -0.4); });
  const auto records = Store();
  ASSERT_THAT(records, SizeIs(1));
  EXPECT_THAT(records[0].agents, testing::ElementsAre("person"));
  EXPECT_EQ(records[0].skill, "");
  EXPECT_EQ(records[0].skill_settings, "");
}

TEST_F(LearningTest, ANameMakesItTheModelOfTheAction) {
  Seat("round_peg_1", "base.round_1");
  Store();
  const auto named = learning_->Name("PlaceRoundPeg", false, actions_);
  ASSERT_TRUE(named) << named.reason();
  const auto records = Store();
  ASSERT_THAT(records, SizeIs(2));
  EXPECT_EQ(records[0].name, "Action1");
  EXPECT_EQ(records[0].sec, "") << "it is not recognised any more";
  EXPECT_EQ(records[1].name, "PlaceRoundPeg");
  EXPECT_EQ(records[1].version, 2);
  EXPECT_THAT(records[1].skill, HasSubstr("insert"));
  const auto again = Seat("round_peg_2", "base.round_2");
  ASSERT_THAT(again, SizeIs(1));
  EXPECT_EQ(again[0].name, "PlaceRoundPeg");
  EXPECT_THAT(Store(), IsEmpty()) << "another showing says nothing new";
}

TEST_F(LearningTest, WhatIsNamedIsRecognisedOfAllThatTheActionTakes) {
  Seat("round_peg_1", "base.round_1");
  Store();
  ASSERT_TRUE(learning_->Name("PlaceRoundPeg", false, actions_));
  Store();
  const auto wider = Seat("shaft", "base.shaft");
  ASSERT_THAT(wider, SizeIs(1));
  EXPECT_EQ(wider[0].name, "PlaceRoundPeg");
  for (const ActionRecord& record : Store()) {
    EXPECT_EQ(record.name, "PlaceRoundPeg") << "it is a showing of it";
  }
  const auto other = Seat("square_peg_1", "base.square_1");
  ASSERT_THAT(other, SizeIs(1));
  EXPECT_EQ(other[0].direction, ActionDirection::kUnknown);
}

TEST_F(LearningTest, ANameOfOtherArgumentsIsRefused) {
  EXPECT_THAT(learning_->Name("PlaceRoundPeg", false, actions_).reason(),
              HasSubstr("nothing was shown"));
  Seat("round_peg_1", "base.round_1");
  EXPECT_THAT(learning_->Name("PlaceSeparator", false, actions_).reason(),
              HasSubstr("PlaceSeparator: it was shown with (round_peg, "
                        "round_hole), but takes (separator)"));
}

TEST_F(LearningTest, AsksOnceUntilTheLibraryHasAnswered) {
  Seat("round_peg_1", "base.round_1");
  EXPECT_THAT(learning_->TakeChanges(actions_), SizeIs(1));
  Seat("round_peg_2", "base.round_2");
  EXPECT_THAT(learning_->TakeChanges(actions_), IsEmpty());
  learning_->OnRefusal();
  Seat("square_peg_1", "base.square_1");
  EXPECT_THAT(learning_->TakeChanges(actions_), SizeIs(2));
}

TEST_F(LearningTest, ARestartGoesOnFromTheRecords) {
  Seat("round_peg_1", "base.round_1");
  Store();
  learning_.emplace(actions_, Hands());
  Seat("round_peg_2", "base.round_2");
  EXPECT_THAT(Store(), IsEmpty());
  Seat("square_peg_2", "base.square_2");
  const auto records = Store();
  ASSERT_THAT(records, SizeIs(1));
  EXPECT_EQ(records[0].name, "Action2");
}

}  // namespace
}  // namespace cell
