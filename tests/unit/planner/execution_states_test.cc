// Each state of an execution alone: what it asks for, and which one follows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/planner/execution/act.h"
#include "services/planner/execution/ask.h"
#include "services/planner/execution/await.h"
#include "services/planner/execution/await_person.h"
#include "services/planner/execution/await_rest.h"
#include "services/planner/execution/clean_up.h"
#include "services/planner/execution/done.h"
#include "services/planner/execution/sense.h"
#include "services/planner/execution/undecided.h"
#include "services/planner/plan_search.h"
#include "tests/unit/bench_domain.h"

namespace cell {

using namespace planner;
namespace {

using testing::IsEmpty;
using testing::SizeIs;

const std::set<std::string> kBothInserted = {"In(bolt_1, hole_1)",
                                             "In(bolt_2, hole_2)"};

/// Both arms are idle, the right one reaches all parts.
class States : public testing::Test {
 protected:
  States() { Report(); }

  void Report(int64_t right_runs = ArmState::kIdle,
              std::optional<std::string> right_holds = {}) {
    ArmState right{bench_.Object("right"), now_.utime, right_runs, {}, {},
                   SkillsOfBench()};
    for (const auto& part : reachable_) {
      right.reachable.push_back(bench_.Object(part));
    }
    if (right_holds) right.held = bench_.Object(*right_holds);
    context_.dispatch.Update(right);
    context_.dispatch.Update(ArmState{bench_.Object("left"),
                                      now_.utime,
                                      ArmState::kIdle,
                                      {},
                                      {},
                                      SkillsOfBench()});
  }
  void Sense(const std::set<std::string>& is_true) {
    context_.sensing.Update({1, now_.utime, bench_.StateOf(is_true)});
  }
  void Pass(int64_t us) { now_.utime += us; }
  /// What takes over; "" if it stays.
  std::string NextAfter(ExecutionState& state) {
    out_ = {};
    const NextState next = state.Step(context_, now_, out_);
    return next ? std::string(next->name()) : "";
  }
  /// Plans, so that waiting states stay.
  State Plan() {
    const State state = context_.StateNow();
    context_.plan.Find(state, {});
    return state;
  }
  static ExecutionStatus Question() {
    return {.state = ExecutionStatus::State::kStuck, .text = "please"};
  }
  void Stop(int arm) {
    context_.dispatch.Start(RequestToCleanUp(arm, {}), {}, State(0), now_,
                            out_);
    context_.dispatch.Update({out_.requests.back().id, now_.utime, arm,
                              SkillResult::Outcome::kStopped, "stopped"});
    Report();
  }

  BenchDomain bench_;
  Instant now_{1'000'000, 125};
  std::vector<std::string> reachable_ = {"bolt_1", "bolt_2", "lid"};
  ExecutionContext context_{
      .params = {},
      .plan = CurrentPlan(bench_.rules, bench_.GoalOf("done"),
                          PlanSearch::Maker({})),
      .dispatch = SkillDispatch(bench_.rules->shared_vocabulary(), {}, 0),
      .sensing = Sensing(0),
      .dialogue = Dialogue(ExecutionParams{}.patience_us),
      .may_act = true};
  Decisions out_;
};

TEST_F(States, AwaitRestLastsUntilAllArmsAreIdleAndWantsAFreshLookThen) {
  AwaitRest rest;
  Sense({});
  Report(7);
  EXPECT_EQ(NextAfter(rest), "");
  Pass(100'000);
  Report();
  context_.may_act = false;
  EXPECT_EQ(NextAfter(rest), "");
  context_.may_act = true;
  EXPECT_EQ(NextAfter(rest), "await");
  EXPECT_EQ(context_.sensing.Fresh(), nullptr);
}

TEST_F(States, AwaitLastsUntilAnArmMayBegin) {
  Await await;
  context_.may_act = false;
  EXPECT_EQ(NextAfter(await), "");
  context_.may_act = true;
  EXPECT_EQ(NextAfter(await), "sense");
}

TEST_F(States, AwaitLetsAnArmThatWasStoppedGoFreeFirst) {
  Await await;
  Stop(bench_.Object("right"));
  EXPECT_EQ(NextAfter(await), "");
  ASSERT_THAT(out_.requests, SizeIs(1));
  EXPECT_EQ(out_.requests[0].skill, "go_free");
}

TEST_F(States, SenseAsksUntilTheStateIsFresh) {
  class Sense sense;
  EXPECT_EQ(NextAfter(sense), "");
  EXPECT_TRUE(out_.sense);
  EXPECT_EQ(NextAfter(sense), "");
  EXPECT_FALSE(out_.sense);
  Pass(200'000);
  EXPECT_EQ(NextAfter(sense), "");
  EXPECT_TRUE(out_.sense);
  Sense({});
  EXPECT_EQ(NextAfter(sense), "act");
  context_.may_act = false;
  EXPECT_EQ(NextAfter(sense), "await");
}

TEST_F(States, SenseDoesNotAskBeforeTheStateHasSettled) {
  class Sense sense;
  context_.sensing.RequireSince(now_.utime + 1);
  EXPECT_EQ(NextAfter(sense), "");
  EXPECT_FALSE(out_.sense);
}

TEST_F(States, ActRequestsTheFirstStepOfThePlan) {
  Act act;
  Sense(kBothInserted);
  EXPECT_EQ(NextAfter(act), "");
  ASSERT_THAT(out_.requests, SizeIs(1));
  EXPECT_EQ(out_.requests[0].arguments.at("part"), bench_.Object("lid"));
  ASSERT_TRUE(out_.plan.has_value());
  EXPECT_EQ(out_.plan->plan.steps.size(), 1u);
  EXPECT_EQ(act.Status(context_).action, "Close(lid)");
  // While it runs there is no new plan.
  Sense({"Closed(lid)"});
  EXPECT_EQ(NextAfter(act), "");
  EXPECT_FALSE(out_.plan.has_value());
  EXPECT_THAT(out_.requests, IsEmpty());
}

TEST_F(States, ActSensesFirstIfTheStateIsOld) {
  Act act;
  Sense({});
  context_.sensing.RequireSince(now_.utime + 1);
  EXPECT_EQ(NextAfter(act), "sense");
}

TEST_F(States, ActIsFollowedByUndecidedWithoutAPlan) {
  Act act;
  reachable_ = {};
  Report();
  Sense({});
  EXPECT_EQ(NextAfter(act), "undecided");
  EXPECT_EQ(out_.plan->plan.result, Plan::Result::kNoPlan);
}

TEST_F(States, ActAsksAtOnceForAStepThatIsLeftToAPerson) {
  Act act;
  context_.params.help_steps = {bench_.Action("Close", {"lid"})};
  Sense(kBothInserted);
  EXPECT_EQ(NextAfter(act), "ask");
}

TEST_F(States, ActAsksAtOnceForAStepThatNoArmCanDo) {
  Act act;
  context_.plan.SetRules(
      BenchDomain(
          BenchWith("    skill: {name: insert, part: X, site: top, arm: "
                    "right}\n",
                    ""))
          .rules);
  Sense(kBothInserted);
  EXPECT_EQ(NextAfter(act), "ask");
}

TEST_F(States, ActIsFollowedByCleanUpWhenTheGoalIsReached) {
  Act act;
  Sense({"Closed(lid)"});
  EXPECT_EQ(NextAfter(act), "clean_up");
}

TEST_F(States, UndecidedAsksTheEstimatorThenThePerson) {
  reachable_ = {"bolt_1", "bolt_2"};
  Report();
  Sense(kBothInserted);
  Undecided undecided(Plan());
  EXPECT_EQ(NextAfter(undecided), "");
  EXPECT_TRUE(out_.sense);
  EXPECT_FALSE(out_.execution.has_value());
  Pass(context_.params.patience_us);
  out_ = {};
  const NextState ask = undecided.Step(context_, now_, out_);
  ASSERT_NE(ask, nullptr);
  EXPECT_EQ(NextAfter(*ask), "");
  ASSERT_TRUE(out_.execution.has_value());
  EXPECT_EQ(out_.execution->text,
            "lid is out of reach of both arms: please move it into reach");
}

TEST_F(States, UndecidedEndsWithAnotherState) {
  reachable_ = {};
  Report();
  Sense({});
  Undecided undecided(Plan());
  EXPECT_EQ(NextAfter(undecided), "");
  reachable_ = {"bolt_1"};
  Report();
  EXPECT_EQ(NextAfter(undecided), "act");
}

TEST_F(States, UndecidedAndAskEndWithOtherRules) {
  Sense({});
  const State state = Plan();
  Undecided undecided(state);
  Ask ask(state, Question());
  EXPECT_EQ(NextAfter(undecided), "");
  EXPECT_EQ(NextAfter(ask), "");
  context_.plan.SetRules(BenchDomain(kBench, 2).rules);
  EXPECT_EQ(NextAfter(undecided), "act");
  EXPECT_EQ(NextAfter(ask), "act");
}

TEST_F(States, AskReportsItsQuestionOnceAndLooksNowAndThen) {
  Sense({});
  Ask ask(Plan(), Question());
  EXPECT_EQ(NextAfter(ask), "");
  EXPECT_EQ(out_.execution, Question());
  EXPECT_TRUE(out_.sense);
  Pass(context_.params.sense_period_us);
  EXPECT_EQ(NextAfter(ask), "");
  EXPECT_FALSE(out_.execution.has_value());
  EXPECT_FALSE(out_.sense);
  Pass(context_.params.watch_period_us);
  EXPECT_EQ(NextAfter(ask), "");
  EXPECT_TRUE(out_.sense);
}

TEST_F(States, AwaitPersonFollowsAChangeAndEndsWhenTheStateStays) {
  Sense({});
  Ask ask(Plan(), Question());
  EXPECT_EQ(NextAfter(ask), "");
  Sense({"In(bolt_1, hole_1)"});
  EXPECT_EQ(NextAfter(ask), "await_person");
  AwaitPerson await_person;
  EXPECT_EQ(NextAfter(await_person), "");
  Pass(context_.params.patience_us);
  EXPECT_EQ(NextAfter(await_person), "act");
}

TEST_F(States, EveryWaitingStateLetsArmsThatWereStoppedGoFreeFirst) {
  Sense({});
  const State state = Plan();
  Undecided undecided(state);
  Ask ask(state, Question());
  AwaitPerson await_person;
  Act act;
  Stop(bench_.Object("right"));
  EXPECT_EQ(NextAfter(undecided), "await");
  EXPECT_EQ(NextAfter(ask), "await");
  EXPECT_EQ(NextAfter(await_person), "await");
  EXPECT_EQ(NextAfter(act), "await");
}

/// What CleanUp asks for and how it ends.
class CleaningUp : public States {
 protected:
  /// Of the arm, which is then idle and empty again.
  void End(int arm, SkillResult::Outcome outcome) {
    const auto running = context_.dispatch.running();
    ASSERT_TRUE(running.contains(arm));
    const auto ended =
        context_.dispatch.Update({running.at(arm).request.id, now_.utime, arm,
                                  outcome, "the way is blocked"});
    ASSERT_TRUE(ended.has_value());
    clean_up_.OnSkillEnd(*ended);
    Report();
  }
  CleanUp clean_up_{3};
  int left_ = bench_.Object("left");
  int right_ = bench_.Object("right");
};

TEST_F(CleaningUp, EmptiesTheGrippersThenGoesHome) {
  Report(ArmState::kIdle, "lid");
  EXPECT_EQ(NextAfter(clean_up_), "");
  ASSERT_THAT(out_.requests, SizeIs(2));
  EXPECT_EQ(out_.requests[0].skill, "go_home");
  EXPECT_EQ(out_.requests[1].skill, "put_down");
  EXPECT_EQ(out_.requests[1].arguments.at("part"), bench_.Object("lid"));
  End(right_, SkillResult::Outcome::kSucceeded);
  EXPECT_EQ(NextAfter(clean_up_), "");
  ASSERT_THAT(out_.requests, SizeIs(1));
  EXPECT_EQ(out_.requests[0].skill, "go_home");
  End(left_, SkillResult::Outcome::kSucceeded);
  End(right_, SkillResult::Outcome::kSucceeded);
  EXPECT_EQ(NextAfter(clean_up_), "done");
}

TEST_F(CleaningUp, LeavesAnArmWhereItIsThatCannotGoHome) {
  EXPECT_EQ(NextAfter(clean_up_), "");
  End(left_, SkillResult::Outcome::kSucceeded);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(NextAfter(clean_up_), "");
    End(right_, SkillResult::Outcome::kFailed);
  }
  out_ = {};
  const NextState done = clean_up_.Step(context_, now_, out_);
  ASSERT_NE(done, nullptr);
  EXPECT_EQ(done->Status(context_).state, ExecutionStatus::State::kDone);
  EXPECT_EQ(done->Status(context_).text, "the way is blocked");
}

TEST_F(CleaningUp, AStopOrAPersonInTheWayIsNoFailure) {
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(NextAfter(clean_up_), "");
    End(right_, SkillResult::Outcome::kYielded);
  }
  EXPECT_EQ(NextAfter(clean_up_), "");
  EXPECT_THAT(out_.requests, SizeIs(1));
}

TEST_F(States, DoneLastsWhateverIsSensed) {
  Done done("");
  Sense({});
  EXPECT_EQ(NextAfter(done), "");
  EXPECT_THAT(out_.requests, IsEmpty());
  EXPECT_FALSE(out_.sense);
}

}  // namespace
}  // namespace cell
