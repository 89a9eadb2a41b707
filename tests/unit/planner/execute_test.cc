#include "services/planner/execute.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "services/planner/plan_search.h"
#include "tests/unit/bench_domain.h"

namespace cell {

using namespace planner;
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int64_t kStepUs = 96'000;  // an arm reports every 12 ticks
constexpr int kPatience = 60;        // steps, after which a person is asked

/// A bench with two arms, of which a test says how what they do ends.
class Bench : public testing::Test {
 protected:
  Bench() { Begin("done"); }

  void Begin(const std::string& goal) {
    execute_ =
        std::make_unique<Execute>(bench_.rules, bench_.GoalOf(goal),
                                  PlanSearch::Maker({}), params_, true, now_);
  }

  struct Arm {
    int64_t request = -1;
    std::string held;
    std::set<std::string> reachable;
  };

  /// Time passes: arms report, asked predicates are answered, the robot
  /// decides.
  void Step(int num_steps = 1) {
    for (int i = 0; i < num_steps; ++i) {
      now_.utime += kStepUs;
      now_.tick += 12;
      for (const auto& [name, arm] : arms_)
        execute_->OnArmState(Report(name, arm));
      if (is_sensing_) {
        execute_->OnSensed(SensedState{0, now_.utime, Sensed()});
        ++num_sensed_;
      }
      is_sensing_ = false;
      const Decisions orders = execute_->Decide(now_);
      is_sensing_ = orders.sense;
      if (orders.execution) told_.push_back(*orders.execution);
      for (const SkillRequest& request : orders.requests) {
        EXPECT_TRUE(ids_.insert(request.id).second);
        asked_.push_back(Show(request));
        requests_.push_back(request);
        if (is_deaf_) continue;
        Arm& arm = arms_.at(Name(request.arm));
        EXPECT_EQ(arm.request, -1) << "two requests to one arm";
        arm.request = request.id;
      }
    }
  }
  /// The skill that the arm does ends.
  void End(const std::string& name,
           SkillResult::Outcome outcome = SkillResult::Outcome::kSucceeded,
           const std::string& reason = "") {
    Arm& arm = arms_.at(name);
    ASSERT_NE(arm.request, -1);
    execute_->OnSkillResult(
        SkillResult{arm.request, now_.utime, Object(name), outcome, reason});
    arm.request = -1;
  }
  void Succeed(const std::string& arm, const std::string& becomes_true) {
    if (!becomes_true.empty()) true_.insert(becomes_true);
    End(arm);
  }
  void Fail(const std::string& arm, const std::string& reason) {
    End(arm, SkillResult::Outcome::kFailed, reason);
  }

  ArmState Report(const std::string& name, const Arm& arm) const {
    ArmState report{Object(name), now_.utime, arm.request,
                    std::nullopt, {},         skills_};
    if (!arm.held.empty()) report.held = Object(arm.held);
    for (const auto& part : arm.reachable) {
      report.reachable.push_back(Object(part));
    }
    return report;
  }
  State Sensed() const { return bench_.StateOf(true_, unknown_); }
  int Object(const std::string& name) const { return bench_.Object(name); }
  std::string Name(int object) const { return bench_.Name(object); }
  std::string Show(const SkillRequest& request) const {
    std::string text = Name(request.arm) + ": " + request.skill;
    std::ranges::replace(text, '_', ' ');
    for (const auto& [name, object] : request.arguments) {
      text += (name == "site" ? " at " : " ") + Name(object);
    }
    return text;
  }
  std::vector<std::string> TakeAsked() { return std::exchange(asked_, {}); }

  BenchDomain bench_;
  ExecutionParams params_;
  std::map<std::string, Arm> arms_ = {
      {"left", {}}, {"right", {-1, "", {"bolt_1", "bolt_2", "lid"}}}};
  std::map<std::string, SkillTraits> skills_ = SkillsOfBench();
  std::set<std::string> true_;
  std::set<std::string> unknown_;
  Instant now_{1'000'000, 125};
  std::unique_ptr<Execute> execute_;
  std::vector<std::string> asked_;
  std::vector<SkillRequest> requests_;
  std::vector<ExecutionStatus> told_;
  std::set<int64_t> ids_;
  bool is_sensing_ = false;
  bool is_deaf_ = false;  // arms lose what they are asked for
  int num_sensed_ = 0;
};

TEST_F(Bench, DoesOneActionAfterTheOtherGoesHomeAndIsDone) {
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_1 at hole_1"));
  EXPECT_EQ(told_.back().action, "Insert(bolt_1, hole_1)");
  Succeed("right", "In(bolt_1, hole_1)");
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_2 at hole_2"));
  Succeed("right", "In(bolt_2, hole_2)");
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert lid at top"));
  Succeed("right", "Closed(lid)");
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("left: go home", "right: go home"));
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kRunning);
  End("left");
  End("right");
  Step(10);
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kDone);
  // What is taken apart afterwards stays so.
  true_.clear();
  execute_->OnSensed(SensedState{1, now_.utime, Sensed()});
  Step(20);
  EXPECT_THAT(TakeAsked(), IsEmpty());
}

TEST_F(Bench, ActsOnNoStateThatIsOlderThanTheResult) {
  Step(10);
  const int num_sensed = num_sensed_;
  Succeed("right", "In(bolt_1, hole_1)");
  const int64_t end = now_.utime;
  // An older state does not show what was done.
  State old = Sensed();
  execute_->OnSensed(SensedState{0, end - 1, old});
  execute_->OnSensed(SensedState{0, end + params_.settle_us - 1, old});
  Step();
  EXPECT_EQ(asked_.size(), 1u);
  Step(9);
  EXPECT_EQ(asked_.size(), 2u);
  EXPECT_GT(num_sensed_, num_sensed);
}

TEST_F(Bench, AsksAgainForPredicatesThatDoNotCome) {
  is_sensing_ = false;
  Step(1);
  for (int i = 0; i < 10; ++i) {
    is_sensing_ = false;  // the request is lost
    Step();
  }
  EXPECT_THAT(asked_, IsEmpty());
  Step(10);
  EXPECT_EQ(asked_.size(), 1u);
}

TEST_F(Bench, DoesNothingUnlessTheModeIsExecute) {
  execute_->SetPermission(false, now_);
  Step(20);
  EXPECT_THAT(asked_, IsEmpty());
  execute_->SetPermission(true, now_);
  Step(10);
  EXPECT_EQ(asked_.size(), 1u);
  // Held while it runs: the end counts, nothing new is begun.
  execute_->SetPermission(false, now_);
  Succeed("right", "In(bolt_1, hole_1)");
  Step(20);
  EXPECT_EQ(asked_.size(), 1u);
  execute_->SetPermission(true, now_);
  Step(10);
  EXPECT_EQ(asked_.size(), 2u);
}

TEST_F(Bench, TriesAgainWhatHasFailedTwice) {
  Step(10);
  for (int i = 0; i < 2; ++i) {
    Fail("right", "it slipped");
    arms_["right"].held = "bolt_1";  // it stays in the gripper
    Step(10);
  }
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_1 at hole_1",
                                       "right: insert bolt_1 at hole_1",
                                       "right: insert bolt_1 at hole_1"));
  arms_["right"].held.clear();
  Succeed("right", "In(bolt_1, hole_1)");
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_2 at hole_2"));
}

TEST_F(Bench, TriesSomethingElseAfterThreeFailures) {
  Step(10);
  for (int i = 0; i < 3; ++i) {
    Fail("right", "it jams");
    Step(10);
  }
  EXPECT_EQ(TakeAsked().back(), "right: insert bolt_1 at hole_2");
}

// Under way the hole looks filled, or the part lost.
TEST_F(Bench, WhatIsSensedUnderWayNeitherPlansNorForgetsFailures) {
  true_ = {"In(bolt_1, hole_1)", "In(bolt_2, hole_2)"};
  Step(10);
  for (int i = 0; i < 3; ++i) {
    true_ = {"In(bolt_1, hole_1)"};
    execute_->OnSensed(SensedState{0, now_.utime, Sensed()});
    Step();
    true_ = {"In(bolt_1, hole_1)", "In(bolt_2, hole_2)"};
    Fail("right", "the lid is bent");
    Step(10);
  }
  Step(kPatience);
  EXPECT_THAT(TakeAsked(), testing::SizeIs(3));
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kStuck);
}

TEST_F(Bench, PassesOnOneAfterTheOtherWhileSomethingIsInserted) {
  arms_["right"].reachable = {"bolt_1"};
  arms_["left"].reachable = {"bolt_2", "lid"};
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_1 at hole_1",
                                       "left: present bolt_2"));
  arms_["right"].reachable.insert("bolt_2");
  End("left");
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("left: present lid"));
  for (int i = 0; i < 5; ++i) {
    if (arms_["left"].request >= 0) Fail("left", "it slipped");
    Step(10);
  }
  EXPECT_THAT(TakeAsked(),
              ElementsAre("left: present lid", "left: present lid"));
}

TEST_F(Bench, AsksThePersonAfterTheOnlyActionHasFailedThreeTimes) {
  true_ = {"In(bolt_1, hole_1)", "In(bolt_2, hole_2)"};
  Step(10);
  for (int i = 0; i < 3; ++i) {
    Fail("right", "the lid is bent");
    Step(10);
  }
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kRunning);
  Step(kPatience);
  EXPECT_THAT(TakeAsked(), testing::SizeIs(3));
  ASSERT_EQ(told_.back().state, ExecutionStatus::State::kStuck);
  EXPECT_EQ(told_.back().text,
            "the right arm has tried 3 times to do Close(lid), and failed: the "
            "lid is bent; please do it yourself, or remove what prevents it");
  // The person bends it straight, which no predicate says.
  DoneAction moved{0, now_.utime, 0, 0, {Object("lid")}, "moving lid"};
  moved.pick_utime = now_.utime - 1;
  execute_->OnAction(moved);
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert lid at top"));
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kRunning);
}

TEST_F(Bench, DoesAllElseBeforeItAsksForAPartOutOfReach) {
  arms_["right"].reachable = {"bolt_1", "bolt_2"};
  Step(kPatience);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_1 at hole_1"));
  Succeed("right", "In(bolt_1, hole_1)");
  Step(kPatience);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_2 at hole_2"));
  Succeed("right", "In(bolt_2, hole_2)");
  Step(kPatience);
  EXPECT_THAT(TakeAsked(), IsEmpty());
  ASSERT_EQ(told_.back().state, ExecutionStatus::State::kStuck);
  EXPECT_THAT(told_.back().text, HasSubstr("lid is out of reach"));
}

TEST_F(Bench, DoesAllElseBeforeItAsksAboutWhatHasFailedTooOften) {
  Step(10);
  bool is_other_hole_filled = false;
  for (int i = 0; i < 10 && arms_["right"].request >= 0; ++i) {
    if (asked_.back().ends_with("hole_1")) {
      Fail("right", "the hole is bent");
    } else {
      is_other_hole_filled = true;
      Succeed("right", "In(" + asked_.back().substr(14, 6) + ", hole_2)");
    }
    Step(kPatience);
  }
  Step(kPatience);
  EXPECT_TRUE(is_other_hole_filled);
  ASSERT_EQ(told_.back().state, ExecutionStatus::State::kStuck);
  EXPECT_THAT(told_.back().text, HasSubstr("the hole is bent"));
}

// No rule says so, but a lid that is closed early keeps the bolts out.
TEST_F(Bench, DoesNothingMeanwhileThatWouldKeepTheGoalFromBeingReached) {
  std::string text = BenchWith(
      "context: [\"In(_, hole_1)\", \"In(_, hole_2)\", not Closed(X)]",
      "context: [not Closed(X)]");
  const std::string goal = "done: [Closed(lid)]";
  text.replace(text.find(goal), goal.size(),
               "done: [Closed(lid), \"In(_, hole_1)\"]");
  bench_ = BenchDomain(text);
  Begin("done");
  arms_["right"].reachable = {"lid"};
  Step(10 + kPatience);
  EXPECT_THAT(TakeAsked(), IsEmpty());
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kStuck);
}

TEST_F(Bench, WhatIsReportedAsDoneButIsNotCountsAsAFailure) {
  true_ = {"In(bolt_1, hole_1)", "In(bolt_2, hole_2)"};
  Step(10);
  for (int i = 0; i < 3; ++i) {
    End("right");
    Step(10);
  }
  Step(kPatience);
  ASSERT_EQ(told_.back().state, ExecutionStatus::State::kStuck);
  EXPECT_THAT(told_.back().text, HasSubstr("reported as done, but is not"));
}

TEST_F(Bench, WhatAHoldHasStoppedIsNoFailure) {
  Step(10);
  for (int i = 0; i < 5; ++i) {
    EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_1 at hole_1"));
    End("right", SkillResult::Outcome::kStopped, "held");
    Step(10);
    EXPECT_THAT(TakeAsked(), ElementsAre("right: go free"));
    End("right");
    Step(10);
  }
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kRunning);
}

// What is held there may be under strain, and look as it is not.
TEST_F(Bench, AnArmThatWasStoppedGoesFreeBeforeTheStateIsSensed) {
  Step(10);
  TakeAsked();
  const int num_sensed = num_sensed_;
  End("right", SkillResult::Outcome::kStopped, "protective stop");
  Step(20);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: go free"));
  EXPECT_EQ(num_sensed_, num_sensed);
  Succeed("right", "In(bolt_1, hole_1)");
  Step(10);
  EXPECT_GT(num_sensed_, num_sensed);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_2 at hole_2"));
}

TEST_F(Bench, StopsDuringGoFreeAreRecoveredFromHoweverOften) {
  Step(10);
  End("right", SkillResult::Outcome::kStopped, "protective stop");
  Step(10);
  TakeAsked();
  for (int i = 0; i < 5; ++i) {
    End("right", SkillResult::Outcome::kStopped, "protective stop");
    Step(10);
    EXPECT_THAT(TakeAsked(), ElementsAre("right: go free"));
  }
}

TEST_F(Bench, AnArmThatCannotGoFreeIsAskedForTheNextActionAllTheSame) {
  Step(10);
  End("right", SkillResult::Outcome::kStopped, "protective stop");
  TakeAsked();
  for (int i = 0; i < 3; ++i) {
    Step(10);
    EXPECT_THAT(TakeAsked(), ElementsAre("right: go free"));
    Fail("right", "what it holds is unknown");
  }
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_1 at hole_1"));
}

TEST_F(Bench, YieldingToAPersonIsNoFailure) {
  Step(10);
  for (int i = 0; i < 5; ++i) {
    End("right", SkillResult::Outcome::kYielded, "a hand is in the way");
    Step(10);
  }
  EXPECT_THAT(TakeAsked(),
              testing::Each(testing::Eq("right: insert bolt_1 at hole_1")));
}

TEST_F(Bench, AsksForNothingThatAPersonPutsBackSoonEnough) {
  arms_["right"].reachable = {"bolt_1", "bolt_2"};
  true_ = {"In(bolt_1, hole_1)", "In(bolt_2, hole_2)"};
  Step(kPatience / 2);
  arms_["right"].reachable.insert("lid");
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert lid at top"));
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kRunning);
}

TEST_F(Bench, ARestartedPlannerWaitsForTheArmsAndSenses) {
  Step(10);
  EXPECT_EQ(TakeAsked().size(), 1u);
  Begin("done");
  Step(20);
  EXPECT_THAT(TakeAsked(), IsEmpty());  // the arm still works
  EXPECT_FALSE(is_sensing_);
  // The result belongs to no request; its effect is sensed.
  Succeed("right", "In(bolt_1, hole_1)");
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_2 at hole_2"));
}

TEST_F(Bench, ARestartedArmIsAskedAgainAfterSensing) {
  Step(10);
  EXPECT_EQ(TakeAsked().size(), 1u);
  const int num_sensed = num_sensed_;
  arms_["right"].request = -1;  // lost by its restart
  Step(20);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: go free"));
  End("right");
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_1 at hole_1"));
  EXPECT_GT(num_sensed_, num_sensed);
}

TEST_F(Bench, AnArmThatDoesNotRespondEndsInAQuestion) {
  is_deaf_ = true;
  true_ = {"In(bolt_1, hole_1)", "In(bolt_2, hole_2)"};
  Step(300);
  EXPECT_EQ(std::ranges::count(TakeAsked(), "right: insert lid at top"), 3);
  ASSERT_EQ(told_.back().state, ExecutionStatus::State::kStuck);
  EXPECT_THAT(told_.back().text, HasSubstr("the arm restarted"));
}

TEST_F(Bench, ASlowArmIsWaitedFor) {
  Step(1000);
  EXPECT_THAT(TakeAsked(), testing::SizeIs(1));
}

TEST_F(Bench, AsksForExactlyThePartThatIsOutOfReachAndGoesOnWhenItIsThere) {
  arms_["right"].reachable = {"bolt_1", "bolt_2"};
  true_ = {"In(bolt_1, hole_1)", "In(bolt_2, hole_2)"};
  Step(10);
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kRunning);
  Step(kPatience);
  ASSERT_EQ(told_.back().state, ExecutionStatus::State::kStuck);
  EXPECT_EQ(told_.back().text,
            "lid is out of reach of both arms: please move it into reach");
  ASSERT_EQ(told_.back().needed.size(), 1u);
  EXPECT_EQ(bench_.rules->vocabulary().AtomName(told_.back().needed[0].atom),
            "Reachable(right, lid)");
  const size_t num_told = told_.size();
  Step(100);
  EXPECT_EQ(told_.size(), num_told);  // asked once
  // It may be in the person's hand yet: only what stays so counts.
  arms_["right"].reachable.insert("lid");
  Step(30);
  EXPECT_THAT(TakeAsked(), IsEmpty());
  Step(50);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert lid at top"));
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kRunning);
}

TEST_F(Bench, GoesOnAsSoonAsThePersonIsSeenToHaveLetGo) {
  arms_["right"].reachable = {"bolt_1", "bolt_2"};
  true_ = {"In(bolt_1, hole_1)", "In(bolt_2, hole_2)"};
  Step(kPatience);
  ASSERT_EQ(told_.back().state, ExecutionStatus::State::kStuck);
  DoneAction action;
  action.pick_utime = now_.utime;
  arms_["right"].reachable.insert("lid");
  Step(10);
  action.utime = now_.utime;
  action.objects = {Object("lid")};
  execute_->OnAction(action);
  Step(20);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert lid at top"));
}

TEST_F(Bench, AStepThatThePersonDoesIsNotDoneAgain) {
  Step(10);
  true_.insert("In(bolt_2, hole_2)");
  Succeed("right", "In(bolt_1, hole_1)");
  Step(10);
  EXPECT_EQ(TakeAsked().back(), "right: insert lid at top");
}

TEST_F(Bench, PassesOnAPartWhileAnotherIsInserted) {
  arms_["right"].reachable = {"bolt_1", "bolt_2"};
  arms_["left"].reachable = {"lid"};
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_1 at hole_1",
                                       "left: present lid"));
  EXPECT_EQ(told_.back().action, "Present(lid), Insert(bolt_1, hole_1)");
  // The other arm's end does not disturb what still runs.
  arms_["right"].held = "bolt_1";
  arms_["right"].reachable.insert("lid");
  End("left");
  Step(20);
  EXPECT_THAT(TakeAsked(), IsEmpty());
  arms_["right"].held.clear();
  Succeed("right", "In(bolt_1, hole_1)");
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_2 at hole_2"));
}

TEST_F(Bench, WhatHandsNothingOverWaitsForItsTurn) {
  skills_.at("present").hands_over = false;
  arms_["right"].reachable = {"bolt_1", "bolt_2"};
  arms_["left"].reachable = {"lid"};
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_1 at hole_1"));
}

TEST_F(Bench, DoesOneThingAtATimeIfToldSo) {
  params_.parallel = false;
  Begin("done");
  arms_["right"].reachable = {"bolt_1", "bolt_2"};
  arms_["left"].reachable = {"lid"};
  Step(20);
  EXPECT_THAT(TakeAsked(), testing::SizeIs(1));
}

TEST_F(Bench, PursuesAnotherGoalOnceTheRunningActionHasEnded) {
  Begin("one");
  Step(10);
  execute_->SetGoal(bench_.GoalOf("done"));
  Step(10);
  EXPECT_THAT(TakeAsked(), testing::SizeIs(1));
  Succeed("right", "In(bolt_1, hole_1)");
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_2 at hole_2"));
}

TEST_F(Bench, AGoalAfterDoneIsPursued) {
  Begin("one");
  true_ = {"In(bolt_1, hole_1)"};
  Step(10);
  End("left");
  End("right");
  Step(2);
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kDone);
  TakeAsked();
  execute_->SetGoal(bench_.GoalOf("done"));
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_2 at hole_2"));
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kRunning);
}

TEST_F(Bench, EmptiesItsGrippersBeforeItGoesHome) {
  Begin("one");
  true_ = {"In(bolt_1, hole_1)"};
  arms_["right"].held = "bolt_2";
  Step(10);
  EXPECT_THAT(TakeAsked(),
              ElementsAre("left: go home", "right: put down bolt_2"));
  arms_["right"].held.clear();
  End("right");
  End("left");
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: go home"));
  for (int i = 0; i < 3; ++i) {
    Fail("right", "the way is blocked");
    Step(10);
  }
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kDone);
  EXPECT_EQ(told_.back().text, "the way is blocked");
}

TEST_F(Bench, PutsDownWhatCannotBePlacedNow) {
  arms_["right"].held = "lid";
  Step(10);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: put down lid"));
}

TEST_F(Bench, LeavesStepsToThePersonAndAsksForThem) {
  params_.help_steps = {bench_.Action("Close", {"lid"})};
  true_ = {"In(bolt_1, hole_1)", "In(bolt_2, hole_2)"};
  Begin("done");
  Step(10);
  EXPECT_THAT(TakeAsked(), IsEmpty());
  ASSERT_EQ(told_.back().state, ExecutionStatus::State::kStuck);
  EXPECT_EQ(told_.back().text, "please do Close(lid)");
  true_.insert("Closed(lid)");
  Step(80);
  EXPECT_THAT(TakeAsked(), ElementsAre("left: go home", "right: go home"));
}

TEST_F(Bench, WaitsForWhatIsUnknownAndThenAsks) {
  unknown_ = {"In(bolt_1, hole_1)", "In(bolt_1, hole_2)", "In(bolt_2, hole_1)",
              "In(bolt_2, hole_2)"};
  Step(20);
  EXPECT_THAT(asked_, IsEmpty());
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kRunning);
  Step(60);
  EXPECT_THAT(asked_, IsEmpty());
  EXPECT_EQ(told_.back().state, ExecutionStatus::State::kStuck);
  unknown_.clear();
  Step(80);
  EXPECT_THAT(TakeAsked(), ElementsAre("right: insert bolt_1 at hole_1"));
}

TEST_F(Bench, RequestsCarryADeadline) {
  Step(10);
  ASSERT_EQ(requests_.size(), 1u);
  EXPECT_GT(requests_[0].deadline_utime, 0);
  EXPECT_LE(requests_[0].deadline_utime,
            now_.utime + params_.dispatch.deadline_us);
}

TEST_F(Bench, TheResultOfAnotherRequestChangesNothing) {
  Step(10);
  TakeAsked();
  execute_->OnSkillResult(SkillResult{77, now_.utime, Object("right"),
                                      SkillResult::Outcome::kFailed, "?"});
  execute_->OnSkillResult(SkillResult{requests_[0].id, now_.utime,
                                      Object("left"),
                                      SkillResult::Outcome::kFailed, "?"});
  Step(20);
  EXPECT_THAT(TakeAsked(), IsEmpty());
}

}  // namespace
}  // namespace cell
