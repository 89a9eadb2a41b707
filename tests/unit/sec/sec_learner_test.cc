#include "common/sec/sec_learner.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <sstream>

#include "common/sec/chain_similarities.h"
#include "common/sec/learned_model_text.h"
#include "tests/unit/sec/showing_testing.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class SecLearnerTest : public testing::Test {
 protected:
  SecLearner New() const {
    return {show_.words(), MakeChainSimilarity(SecLearner::kMeasure), {}};
  }
  void Name(const std::string& name, bool is_undone = false) {
    ASSERT_TRUE(last_) << "before " << name;
    const auto group = learner_.Name(*last_, name, is_undone);
    EXPECT_TRUE(group) << group.reason();
  }
  LearnedModel ModelOf(const std::string& name) const {
    for (const SecLearner::Action& action : learner_.Actions()) {
      if (action.name == name) return action.model;
    }
    ADD_FAILURE() << "nothing is known of " << name;
    return {};
  }
  std::string TextOf(const std::string& name) const {
    return ToText(ModelOf(name), show_.words()->vocabulary);
  }
  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const auto& action : learner_.Actions()) names.push_back(action.name);
    return names;
  }

  std::string source_ = "test 1";
  std::optional<SecLearner::Lesson> last_;
  Demonstration show_{
      [this](const ObservedManipulation& manipulation, const auto&) {
        last_ = learner_.Add(manipulation, source_, "1.0");
      }};
  SecLearner learner_ = New();
};

TEST_F(SecLearnerTest, OneShowingSaysWhatChanges) {
  show_.Seat("round_peg_1", "base.round_2");
  Name("Insert");
  const LearnedModel model = ModelOf("Insert");
  EXPECT_EQ(model.NumShown(), 1);
  const std::string all = TextOf("Insert");
  const std::string text = all.substr(0, all.find("taught"));
  EXPECT_THAT(text, HasSubstr("roles: {X: round_peg, Y: round_hole}"));
  EXPECT_THAT(text, HasSubstr("fits(X, Y)"));
  EXPECT_THAT(text, HasSubstr("not PegInHole(X, Y)"));
  EXPECT_THAT(text, HasSubstr("apart: [Y]"));
  // What does not change tells nothing.
  EXPECT_THAT(text, Not(HasSubstr("Horizontal")));
  EXPECT_THAT(text, Not(HasSubstr("Clear")));
}

TEST_F(SecLearnerTest, ShowingsOfOneChangeWithOneTypeFormAGroup) {
  show_.Seat("round_peg_1", "base.round_2");
  EXPECT_TRUE(last_->is_new);
  show_.Seat("square_peg_1", "base.square_1");
  EXPECT_TRUE(last_->is_new) << "other types";
  show_.Seat("round_peg_2", "base.round_1");
  EXPECT_FALSE(last_->is_new);
  show_.Seat("square_peg_2", "base.square_2");
  show_.Seat("separator", "base.separator");
  EXPECT_THAT(Names(), ElementsAre("Action1", "Action2", "Action3"));
  EXPECT_EQ(ModelOf("Action1").NumShown(), 2);
}

TEST_F(SecLearnerTest, ANameJoinsWhatTypesKeepApart) {
  show_.Seat("round_peg_1", "base.round_2");
  Name("Insert");
  show_.Seat("shaft", "base.shaft");
  Name("Insert");
  EXPECT_THAT(Names(), ElementsAre("Insert"));
  EXPECT_THAT(TextOf("Insert"),
              HasSubstr("roles: {X: cylindrical_peg, Y: cylindrical_hole}"));
}

TEST_F(SecLearnerTest, ATakeBackIsAShowingOfTheSameActionReversed) {
  show_.Seat("pendulum", "base.pendulum");
  Name("Hang");
  const std::string once = TextOf("Hang");
  show_.Stand("pendulum", 0, -0.4);
  EXPECT_EQ(last_->direction, ActionDirection::kReversed);
  EXPECT_THAT(Names(), ElementsAre("Hang"));
  EXPECT_EQ(ModelOf("Hang").NumShown(), 2);
  EXPECT_EQ(TextOf("Hang").substr(0, TextOf("Hang").find("shown")),
            once.substr(0, once.find("shown")));
}

TEST_F(SecLearnerTest, WhatUndoesAnActionTeachesIt) {
  show_.Lay("square_peg_1", 0.1, -0.4);
  Name("Raise", true);
  const LearnedModel model = ModelOf("Raise");
  ASSERT_THAT(model.RequiredLiterals(), SizeIs(1));
  EXPECT_EQ(ToText(*model.RequiredLiterals().begin(), show_.words()->vocabulary,
                   model.roles),
            "Horizontal(X)");
}

TEST_F(SecLearnerTest, AMoveThatChangesNothingTeachesNothing) {
  show_.Stand("separator", 0.3, -0.3);
  EXPECT_FALSE(last_);
  EXPECT_THAT(learner_.Actions(), IsEmpty());
}

TEST_F(SecLearnerTest, RefusesANameThatDoesNotFitAndSaysWhy) {
  show_.Seat("round_peg_1", "base.round_2");
  Name("Insert");
  EXPECT_THAT(learner_.Name(*last_, "Hang", false).reason(),
              HasSubstr("known as Insert"));
  EXPECT_THAT(learner_.Name(*last_, "Insert", true).reason(),
              HasSubstr("was done, not undone"));
  show_.Seat("pendulum", "base.pendulum");
  EXPECT_THAT(learner_.Name(*last_, "Insert", false).reason(),
              HasSubstr("does not change what Insert changes"));
  show_.Seat("shaft", "base.shaft");
  EXPECT_THAT(learner_.Name(*last_, "Insert", true).reason(),
              HasSubstr("was done, not undone"));
}

TEST_F(SecLearnerTest, TheOrderOfTheShowingsDoesNotMatter) {
  using Step = std::function<void()>;
  const Eigen::Isometry3d X_WO_square_peg =
      show_.stage().PoseOf("square_peg_1");
  const auto seat = [this](const char* part, const char* site,
                           const char* name) -> Step {
    return [=, this] {
      const Eigen::Isometry3d X_WO = show_.stage().PoseOf(part);
      show_.Seat(part, site);
      Name(name);
      show_.Manipulate(part, [&] { show_.stage().Put(part, X_WO); });
    };
  };
  const std::vector<Step> steps = {
      seat("shaft", "base.shaft", "Insert"),
      seat("round_peg_1", "base.round_1", "Insert"),
      seat("round_peg_2", "base.round_2", "Insert"),
      seat("separator", "base.separator", "Separate"), [this] {
        show_.Lay("square_peg_1", 0.1, -0.4);
        Name("Raise", true);
      }};
  std::vector<size_t> order(steps.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::string first;
  for (int turn = 0; turn < 6; ++turn) {
    learner_ = New();
    show_.stage().Put("square_peg_1", X_WO_square_peg);
    for (const size_t i : order) steps[i]();
    std::string all;
    for (const auto& action : learner_.Actions()) {
      all += action.name + TextOf(action.name);
    }
    // The chain is that of the first showing.
    if (turn == 0) first = all;
    std::ranges::rotate(order, order.begin() + 2);
    const auto without_chains = [](const std::string& text) {
      std::string kept;
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);) {
        if (line.find("chain:") == std::string::npos) kept += line + "\n";
      }
      return kept;
    };
    EXPECT_EQ(without_chains(all), without_chains(first)) << turn;
  }
}

/// Whatever else has been shown: without it, the models are those of a learner
/// that has never seen it.
TEST_F(SecLearnerTest, ADemonstrationThatIsTakenBackHasTaughtNothing) {
  const auto seat = [this](const char* part, const char* site,
                           const char* name) {
    const Eigen::Isometry3d X_WO = show_.stage().PoseOf(part);
    show_.Seat(part, site);
    Name(name);
    show_.Manipulate(part, [&] { show_.stage().Put(part, X_WO); });
  };
  const std::vector<std::function<void()>> demonstrations = {
      [&] { seat("round_peg_1", "base.round_1", "Insert"); },
      [&] {
        seat("shaft", "base.shaft", "Insert");
        seat("separator", "base.separator", "Separate");
      },
      [&] {
        seat("round_peg_2", "base.round_2", "Insert");
        seat("round_peg_1", "base.round_2", "Insert");
      }};
  const auto learned_from = [&](const std::vector<size_t>& which) {
    learner_ = New();
    for (const size_t i : which) {
      source_ = "demonstration " + std::to_string(i);
      demonstrations[i]();
    }
  };
  const auto all = [&] {
    std::string text;
    for (const auto& action : learner_.Actions()) {
      text += action.name + ":\n" + TextOf(action.name) + "\n";
    }
    return text;
  };
  for (size_t bad = 0; bad < demonstrations.size(); ++bad) {
    std::vector<size_t> good;
    for (size_t i = 0; i < demonstrations.size(); ++i) {
      if (i != bad) good.push_back(i);
    }
    learned_from(good);
    const std::string expected = all();
    learned_from({0, 1, 2});
    const std::string before = all();
    const auto names =
        learner_.TakeBack("demonstration " + std::to_string(bad));
    ASSERT_TRUE(names) << names.reason();
    EXPECT_EQ(names->size(), bad == 1 ? 2u : 1u);
    EXPECT_NE(before, expected);
    EXPECT_EQ(all(), expected) << "without " << bad;
  }
  const std::string before = all();
  const auto names = learner_.TakeBack("demonstration 9");
  ASSERT_TRUE(names) << names.reason();
  EXPECT_THAT(*names, testing::IsEmpty());
  EXPECT_EQ(all(), before);
}

TEST_F(SecLearnerTest, WhatCannotBeToldFromOthersIsNotTakenBack) {
  show_.Seat("round_peg_1", "base.round_2");
  Name("Insert");
  LearnedModel model = ModelOf("Insert");
  model.taught.clear();  // as an older build has kept it
  model.shown = {{"a 1", 1}, {"b 2", 1}};
  learner_ = New();
  learner_.Know("Insert", model);
  EXPECT_THAT(learner_.TakeBack("a 1").reason(),
              HasSubstr("what 'a 1' has taught Insert is only known together "
                        "with: b 2"));
  EXPECT_THAT(Names(), ElementsAre("Insert"));
}

TEST_F(SecLearnerTest, MergesActionsThatShareAChange) {
  show_.Seat("round_peg_1", "base.round_2");
  show_.Seat("shaft", "base.shaft");
  show_.Seat("separator", "base.separator");
  EXPECT_THAT(learner_.Merge("Action1", "Action3").reason(),
              HasSubstr("does not change what Action3 changes"));
  const auto merged = learner_.Merge("Action2", "Action1");
  EXPECT_TRUE(merged) << merged.reason();
  EXPECT_THAT(Names(), ElementsAre("Action1", "Action3"));
  EXPECT_THAT(TextOf("Action1"),
              HasSubstr("roles: {X: cylindrical_peg, Y: cylindrical_hole}"));
  EXPECT_EQ(ModelOf("Action1").NumShown(), 2);
}

TEST_F(SecLearnerTest, AForgottenActionIsNewWhenItIsShownAgain) {
  show_.Seat("round_peg_1", "base.round_2");
  learner_.Forget("Action1");
  EXPECT_THAT(learner_.Actions(), IsEmpty());
  EXPECT_THAT(learner_.Name(*last_, "Insert", false).reason(),
              HasSubstr("has been taken back"));
  show_.Seat("round_peg_2", "base.round_1");
  EXPECT_TRUE(last_->is_new);
  EXPECT_THAT(Names(), ElementsAre("Action2"));
}

TEST_F(SecLearnerTest, KeepsSoManyDemonstrationsApartAndTheirCommonFactsThen) {
  for (int i = 0; i < 20; ++i) {
    source_ = "test " + std::to_string(i);
    show_.Seat("separator", "base.separator");
    show_.Stand("separator", 0.2, -0.3);
  }
  const LearnedModel model = ModelOf("Action1");
  EXPECT_EQ(model.taught.size(), ShowingGroup::kMaxTaught);
  EXPECT_EQ(model.NumShown(), 40);
  EXPECT_EQ(model.taught.front().shown.size(), 5u);
}

TEST_F(SecLearnerTest, GoesOnFromWhatItKnows) {
  show_.Seat("round_peg_1", "base.round_2");
  Name("Insert");
  show_.Seat("separator", "base.separator");
  const auto known = learner_.Actions();
  learner_ = New();
  for (const auto& action : known) learner_.Know(action.name, action.model);
  show_.Seat("round_peg_2", "base.round_1");
  EXPECT_FALSE(last_->is_new);
  show_.Stand("separator", 0.2, -0.3);
  EXPECT_FALSE(last_->is_new);
  show_.Seat("head", "pendulum.head");
  EXPECT_TRUE(last_->is_new);
  EXPECT_THAT(Names(), ElementsAre("Action2", "Action3", "Insert"));
  EXPECT_EQ(ModelOf("Insert").NumShown(), 2);
}

}  // namespace
}  // namespace cell
