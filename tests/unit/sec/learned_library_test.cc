#include "common/sec/learned_library.h"

#include <gmock/gmock.h>

#include <map>

#include "common/actions/sec_models.h"
#include "common/sec/learned_model_text.h"
#include "tests/unit/sec/showing_testing.h"

namespace cell {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Models as texts, and how well what is shown agrees with them.
class LearnedLibraryTest : public testing::Test {
 protected:
  void Learn(const std::string& name, const std::string& text) {
    entries_.push_back({name, LearnedModelFromConfig(Config::Parse(text, name),
                                                     *show_.words())});
  }
  void Learn() {
    Learn("Insert",
          "{roles: {X: peg, Y: hole}, moved: X,"
          " pick: {touch: [table], apart: [Y],"
          "        where: ['fits(X, Y)', 'not PegInHole(X, Y)']},"
          " place: {touch: [Y], apart: [table], where: ['PegInHole(X, Y)']},"
          " chain: {table: 10}, shown: {a: 1}}");
    Learn("Raise",
          "{roles: {X: peg}, moved: X, pick: {where: [Horizontal(X)]},"
          " place: {where: [not Horizontal(X)]},"
          " chain: {table: 11}, shown: {a: 1}}");
    Learn("Rest",
          "{roles: {X: pendulum}, moved: X,"
          " pick: {touch: [table], apart: [any shaft, base]},"
          " place: {touch: [any shaft, base], apart: [table]},"
          " chain: {shaft: 01}, shown: {a: 1}}");
  }

  void Judge(const ObservedManipulation& manipulation) {
    agreements_.clear();
    const LearnedLibrary library(entries_, show_.words());
    for (const auto& model : library.models()) {
      for (const auto direction :
           {ActionDirection::kForward, ActionDirection::kReversed}) {
        for (const auto& roles : model->RolesAtPickUp(
                 manipulation.part, manipulation.before, direction)) {
          const double agreement =
              model->Agreement(manipulation, roles, direction);
          if (agreement == 0) continue;
          const bool is_forward = direction == ActionDirection::kForward;
          agreements_[(is_forward ? "" : "un") + model->action() + " " +
                      roles.back()] = agreement;
        }
      }
    }
  }

  std::vector<LearnedLibrary::Entry> entries_;
  std::map<std::string, double> agreements_;
  Demonstration show_{
      [this](const ObservedManipulation& manipulation, const auto&) {
        Judge(manipulation);
      }};
};

using testing::DoubleEq;
using testing::Pair;

TEST_F(LearnedLibraryTest, WhatWasShownAgreesWholly) {
  Learn();
  show_.Seat("round_peg_1", "base.round_1");
  EXPECT_THAT(agreements_, ElementsAre(Pair("Insert base.round_1", 1)));
  show_.Stand("round_peg_1", 0.2, -0.3);
  EXPECT_THAT(agreements_, ElementsAre(Pair("unInsert base.round_1", 1)));
}

// From site to site: two relations differ from what the model says, and a
// predicate changes that it does not mention.
TEST_F(LearnedLibraryTest, WhatIsMissingOrUnexplainedCountsAgainstIt) {
  Learn();
  show_.stage().Seat("round_peg_1", "base.round_1");
  show_.Seat("round_peg_1", "base.round_2");
  const double expected = 6.0 / (8 + 4);
  EXPECT_THAT(agreements_,
              ElementsAre(Pair("Insert base.round_2", DoubleEq(expected)),
                          Pair("unInsert base.round_1", DoubleEq(expected))));
}

TEST_F(LearnedLibraryTest, ALyingPegThatIsInsertedIsNotSetUpright) {
  Learn();
  show_.stage().LieAt("square_peg_1", 0.1, -0.4);
  show_.Seat("square_peg_1", "base.square_2");
  EXPECT_GT(agreements_.at("Insert base.square_2"), LearnedLibrary::kThreshold);
  EXPECT_LT(agreements_.at("Raise square_peg_1"), LearnedLibrary::kThreshold);
}

TEST_F(LearnedLibraryTest, WithoutPredicatesTheRelationsMustChange) {
  Learn();
  show_.stage().Seat("shaft", "base.shaft");
  const Eigen::Isometry3d too_high(Eigen::Translation3d(0, 0, 0.0015));
  show_.Manipulate("pendulum", [&] {
    show_.stage().Seat("pendulum", "base.pendulum", too_high);
  });
  EXPECT_THAT(agreements_, ElementsAre(Pair("Rest pendulum", 1)));
  show_.Stand("pendulum", 0.3, -0.35);
  EXPECT_THAT(agreements_, ElementsAre(Pair("unRest pendulum", 1)));
  show_.Stand("pendulum", 0.1, -0.35);
  EXPECT_THAT(agreements_, IsEmpty());
}

/// Poses that cannot tell whether anything is seated.
class NoisyLibraryTest : public LearnedLibraryTest {
 protected:
  Demonstration noisy_{[this](const ObservedManipulation& manipulation,
                              const auto&) { Judge(manipulation); },
                       {.position = 0.002}};
};

TEST_F(NoisyLibraryTest, RelationsDecideWhatPosesLeaveOpen) {
  Learn();
  noisy_.Seat("round_peg_1", "base.round_1");
  EXPECT_THAT(agreements_,
              ElementsAre(Pair("Insert base.round_1", DoubleEq(7.0 / 8))));
  noisy_.Stand("round_peg_1", 0.2, -0.3);
  EXPECT_THAT(agreements_,
              ElementsAre(Pair("unInsert base.round_1", DoubleEq(7.0 / 8))));
  noisy_.Stand("round_peg_1", 0.3, -0.3);
  EXPECT_THAT(agreements_, IsEmpty());
}

// It touches the site's host before and after.
TEST_F(NoisyLibraryTest, WithoutAChangeOfRelationsNothingIsDecided) {
  Learn();
  const Eigen::Isometry3d above(Eigen::Translation3d(0, 0, 0.002));
  noisy_.stage().Seat("round_peg_1", "base.round_1");
  noisy_.Manipulate("round_peg_1", [&] {
    noisy_.stage().Seat("round_peg_1", "base.round_1", above);
  });
  EXPECT_THAT(agreements_, IsEmpty());
}

TEST_F(LearnedLibraryTest, OnlyWhatFitsTakesPart) {
  Learn();
  const LearnedLibrary library(entries_, show_.words());
  const SensedFrame before{
      show_.stage().Frame(),
      show_.task().MakeSensor()->Sense(
          SceneOf(show_.stage().Frame(), show_.task().scene_objects))};
  EXPECT_THAT(library.models()[0]->RolesAtPickUp("shaft", before,
                                                 ActionDirection::kForward),
              ElementsAre(ElementsAre("shaft", "base.shaft")));
  EXPECT_THAT(library.models()[0]->RolesAtPickUp("shaft", before,
                                                 ActionDirection::kReversed),
              IsEmpty())
      << "it is in no hole";
  EXPECT_THAT(library.models()[0]->RolesAtPickUp("head", before,
                                                 ActionDirection::kForward),
              IsEmpty());
}

/// A part of a type that the model was never shown with, in its role.
TEST_F(LearnedLibraryTest, APartThatWasNeverShownIsTakenForTheRoleItPlays) {
  const auto insert = [](const std::string& x, const std::string& y) {
    return "{roles: {X: " + x + ", Y: " + y +
           "}, moved: X,"
           " pick: {touch: [table], apart: [Y],"
           "        where: ['fits(X, Y)', 'not PegInHole(X, Y)']},"
           " place: {touch: [Y], apart: [table], where: ['PegInHole(X, Y)']},"
           " chain: {table: 10}, shown: {a: 1}}";
  };
  Learn("Insert", insert("shaft", "cylindrical_hole"));
  show_.Seat("round_peg_1", "base.round_2");
  EXPECT_THAT(agreements_,
              ElementsAre(testing::Pair("Insert base.round_2", 1.0)));
  const LearnedLibrary library(entries_, show_.words());
  EXPECT_TRUE(library.models()[0]->HasStandIn({"round_peg_1", "base.round_2"}));
  EXPECT_FALSE(library.models()[0]->HasStandIn({"shaft", "base.shaft"}));
  show_.Seat("square_peg_1", "base.square_1");
  EXPECT_THAT(agreements_, IsEmpty()) << "its hole plays no role";
  show_.Seat("separator", "base.separator");
  EXPECT_THAT(agreements_, IsEmpty()) << "it can be in no hole";
  // Once it has an action of its own that changes the same, it stands in for
  // none.
  Learn("Plug", insert("round_peg", "round_hole"));
  show_.Seat("round_peg_2", "base.round_1");
  EXPECT_THAT(agreements_,
              ElementsAre(testing::Pair("Plug base.round_1", 1.0)));
}

}  // namespace
}  // namespace cell
