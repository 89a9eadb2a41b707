#include "services/planner/monitor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/cranfield_domain.h"

namespace cell {

using namespace planner;
namespace {

using testing::HasSubstr;

/// A person at the task: states at key frames, actions with pick and place.
class Watched : public testing::Test {
 protected:
  Watched() : monitor_(cranfield_.rules, MakeSearch(), {}) { Sense(state_); }

  std::unique_ptr<Solver> MakeSearch() const {
    return std::make_unique<PlanSearch>(cranfield_.ProblemOf(Agent::kPerson),
                                        PlanSearch::Params{});
  }
  /// A key frame at which `state` is sensed.
  void Sense(const State& state) {
    state_ = state;
    Keep(monitor_.Update(SensedState{++frame_, frame_ * 1000, state}));
  }
  /// The action was made from the key frame `pick` to the last one.
  void Report(const std::string& text, const std::vector<int>& objects,
              int64_t pick) {
    Keep(monitor_.Update(
        DoneAction{++index_, frame_ * 1000, pick, frame_, objects, text}));
  }
  void Keep(const Decisions& report) {
    if (report.plan) plans_.push_back(*report.plan);
    alerts_.insert(alerts_.end(), report.alerts.begin(), report.alerts.end());
  }
  std::vector<int> Objects(const std::vector<std::string>& names) const {
    std::vector<int> objects;
    for (const auto& name : names) {
      objects.push_back(
          cranfield_.domain->vocabulary().FindObject(name).value());
    }
    return objects;
  }

  /// Picks up and places, each a key frame; the state changes at the second.
  void Place(const GroundAction& action) {
    Sense(state_);
    const int64_t pick = frame_;
    Sense(cranfield_.Do(state_, action));
    Report(cranfield_.domain->Show(action), action.arguments, pick);
  }
  /// Takes a placed part out and puts it on the table; the state changes
  /// when it is lifted, one key frame after it was taken.
  void TakeBack(const GroundAction& placed) {
    for (const GroundAction& back :
         cranfield_.domain->GroundActions(Agent::kPerson)) {
      const auto& undoes = cranfield_.domain->actions()[back.action].undoes;
      if (undoes != placed.action || back.arguments != placed.arguments ||
          cranfield_.RulesFor(back, state_).empty()) {
        continue;
      }
      Sense(state_);
      const int64_t pick = frame_;
      Sense(cranfield_.Do(state_, back));
      Sense(state_);
      Report("taking back " + cranfield_.domain->Show(placed), placed.arguments,
             pick);
      return;
    }
    ADD_FAILURE() << "cannot take back";
  }

  Cranfield cranfield_;
  Monitor monitor_;
  State state_ = cranfield_.Start();
  int64_t frame_ = -1;
  int64_t index_ = -1;
  std::vector<PlanOfState> plans_;
  std::vector<Alert> alerts_;
};

TEST_F(Watched, TheFirstStateGivesAPlan) {
  ASSERT_EQ(plans_.size(), 1u);
  EXPECT_EQ(plans_[0].plan.result, Plan::Result::kFound);
  EXPECT_EQ(plans_[0].key_frame, 0);
}

TEST_F(Watched, AValidOrderGivesAPlanAfterEachActionAndNoAlert) {
  std::mt19937_64 random(4);
  for (const GroundAction& action : cranfield_.RandomOrder(random)) {
    const size_t before = plans_.size();
    Place(action);
    EXPECT_GT(plans_.size(), before);
    EXPECT_EQ(plans_.back().key_frame, frame_);
  }
  EXPECT_EQ(plans_.back().plan.result, Plan::Result::kGoalReached);
  EXPECT_TRUE(alerts_.empty());
}

TEST_F(Watched, NoneOfManyValidOrdersGivesAnAlert) {
  std::mt19937_64 random(5);
  for (int run = 0; run < 100; ++run) {
    Sense(cranfield_.Start());
    for (const auto& action : cranfield_.RandomOrder(random)) Place(action);
  }
  EXPECT_TRUE(alerts_.empty()) << alerts_[0].text;
}

TEST_F(Watched, TakingBackAnyPlacedPartGivesExactlyOneWarning) {
  std::mt19937_64 random(6);
  for (int run = 0; run < 20; ++run) {
    Sense(cranfield_.Start());
    for (const GroundAction& action : cranfield_.RandomOrder(random)) {
      Place(action);
      EXPECT_TRUE(alerts_.empty()) << alerts_[0].text;
      TakeBack(action);
      ASSERT_EQ(alerts_.size(), 1u) << cranfield_.domain->Show(action);
      EXPECT_EQ(alerts_[0].cause, Alert::Cause::kLongerPlan);
      EXPECT_THAT(alerts_[0].text, HasSubstr(cranfield_.domain->Show(action)));
      alerts_.clear();
      Place(action);
      EXPECT_TRUE(alerts_.empty()) << alerts_[0].text;
    }
  }
}

TEST_F(Watched, LiftingAPlacedPartAndPuttingItBackIsNoDeviation) {
  const GroundAction place =
      *cranfield_.domain->FindGroundAction("PlacePendulum", {"pendulum"});
  Place(*cranfield_.domain->FindGroundAction("PlaceRoundPeg",
                                             {"shaft", "base.shaft"}));
  Place(place);
  const State placed = state_;
  Sense(placed);
  const int64_t pick = frame_;
  Sense(cranfield_.Do(placed, "RemovePendulum", {"pendulum"}));
  Sense(placed);
  Report("PlacePendulum(pendulum)", place.arguments, pick);
  EXPECT_TRUE(alerts_.empty());
}

// The left hand lifts a placed peg while the right one places another: the
// plan is as long as before, yet one of them deviates.
TEST_F(Watched, OfTwoHandsOnlyTheOneThatDeviatesIsWarned) {
  Place(*cranfield_.domain->FindGroundAction("PlaceRoundPeg",
                                             {"round_peg_1", "base.round_1"}));
  const auto right = *cranfield_.domain->FindGroundAction(
      "PlaceSquarePeg", {"square_peg_1", "base.square_1"});
  Sense(state_);
  const int64_t pick_right = frame_;
  Sense(state_);
  const int64_t pick_left = frame_;
  Sense(
      cranfield_.Do(state_, "RemoveRoundPeg", {"round_peg_1", "base.round_1"}));
  Sense(cranfield_.Do(state_, right));
  Report("PlaceSquarePeg(square_peg_1, base.square_1)", right.arguments,
         pick_right);
  EXPECT_TRUE(alerts_.empty());
  Sense(state_);
  Report("taking back PlaceRoundPeg(round_peg_1, base.round_1)",
         Objects({"round_peg_1", "base.round_1"}), pick_left);
  ASSERT_EQ(alerts_.size(), 1u);
  EXPECT_THAT(alerts_[0].text, HasSubstr("round_peg_1"));
}

TEST_F(Watched, TheSeparatorTooEarlyIsAWarningThatNamesIt) {
  Sense(state_);
  const int64_t pick = frame_;
  State state = cranfield_.With(state_, {"SeparatorPlaced(separator)"});
  Sense(cranfield_.With(state, {"Free(base.square_1)", "Free(base.square_2)"},
                        Truth::kFalse));
  Report("PlaceSeparator(separator)", Objects({"separator"}), pick);
  ASSERT_EQ(alerts_.size(), 1u);
  EXPECT_EQ(alerts_[0].cause, Alert::Cause::kLongerPlan);
  EXPECT_EQ(alerts_[0].text,
            "PlaceSeparator(separator) has made the way to the goal longer: "
            "10.5 instead of 9.5 expected actions; best next: "
            "PlaceRoundPeg(round_peg_1, base.round_1)");
  // Taking it off again is no deviation.
  Sense(state_);
  const int64_t pick_again = frame_;
  Sense(cranfield_.Do(state_, "RemoveSeparator", {"separator"}));
  Report("taking back PlaceSeparator(separator)", Objects({"separator"}),
         pick_again);
  EXPECT_EQ(alerts_.size(), 1u);
}

TEST_F(Watched, APartOutOfReachIsAnErrorWithItsReason) {
  Sense(state_);
  const int64_t pick = frame_;
  Sense(cranfield_.With(state_, {"Clear(shaft)"}, Truth::kFalse));
  Report("moving shaft", Objects({"shaft"}), pick);
  ASSERT_EQ(alerts_.size(), 1u);
  EXPECT_EQ(alerts_[0].cause, Alert::Cause::kNoPlan);
  EXPECT_THAT(alerts_[0].text,
              HasSubstr("; please make sure that Clear(shaft)"));
  EXPECT_EQ(alerts_[0].utime, frame_ * 1000);
  // Back within reach: the way is no longer than it was.
  Sense(state_);
  const int64_t pick_again = frame_;
  Sense(cranfield_.Start());
  Report("moving shaft", Objects({"shaft"}), pick_again);
  EXPECT_EQ(alerts_.size(), 1u);
}

TEST_F(Watched, AnUndecidedStateDefersTheWarning) {
  const auto place = *cranfield_.domain->FindGroundAction(
      "PlaceRoundPeg", {"shaft", "base.shaft"});
  Place(place);
  Sense(state_);
  const int64_t pick = frame_;
  const State out =
      cranfield_.Do(state_, "RemoveRoundPeg", {"shaft", "base.shaft"});
  Sense(cranfield_.With(out, {"Clear(shaft)"}, Truth::kUnknown));
  Report("taking back", place.arguments, pick);
  EXPECT_TRUE(alerts_.empty());
  EXPECT_EQ(plans_.back().plan.result, Plan::Result::kUndecided);
  Sense(out);
  EXPECT_EQ(alerts_.size(), 1u);
  Sense(out);
  EXPECT_EQ(alerts_.size(), 1u);
}

TEST_F(Watched, AnActionMayComeBeforeItsStateAndTwice) {
  const auto place = *cranfield_.domain->FindGroundAction(
      "PlaceRoundPeg", {"shaft", "base.shaft"});
  Place(place);
  const size_t num_plans = plans_.size();
  const DoneAction back{
      7, 5000, frame_ + 1, frame_ + 2, place.arguments, "taking back"};
  Keep(monitor_.Update(back));
  Keep(monitor_.Update(back));
  EXPECT_EQ(plans_.size(), num_plans);
  Sense(state_);
  Sense(cranfield_.Start());
  Keep(monitor_.Update(back));
  EXPECT_EQ(alerts_.size(), 1u);
  EXPECT_EQ(plans_.size(), num_plans + 1);
}

TEST_F(Watched, TheSameStateAgainTellsNothing) {
  Sense(state_);
  Sense(state_);
  EXPECT_EQ(plans_.size(), 1u);
  Sense(cranfield_.With(state_, {"Horizontal(shaft)"}));
  EXPECT_EQ(plans_.size(), 2u);
  EXPECT_TRUE(alerts_.empty());
}

TEST_F(Watched, AnOlderStateThatComesLateDoesNotReplaceThePlan) {
  Sense(state_);
  Sense(state_);
  Keep(monitor_.Update(SensedState{
      frame_ + 10, 1, cranfield_.With(state_, {"Horizontal(shaft)"})}));
  const size_t num_plans = plans_.size();
  Keep(monitor_.Update(SensedState{frame_ + 5, 1, state_}));
  EXPECT_EQ(plans_.size(), num_plans);
}

TEST(Monitor, RemembersNoMoreThanItMay) {
  const Cranfield cranfield;
  Monitor monitor(
      cranfield.rules,
      std::make_unique<PlanSearch>(cranfield.ProblemOf(Agent::kPerson),
                                   PlanSearch::Params{}),
      {0.5, 4});
  for (int64_t i = 0; i < 100; ++i) {
    monitor.Update(SensedState{i, i, cranfield.Start()});
    monitor.Update(DoneAction{i, i, i, i + 1'000'000, {}, "moving"});
  }
  // The state before is forgotten; nothing to compare with, no alert.
  const auto report =
      monitor.Update(DoneAction{1000, 5, 2, 99, {}, "a long one"});
  EXPECT_TRUE(report.alerts.empty());
  EXPECT_TRUE(report.plan.has_value());
}

}  // namespace
}  // namespace cell
