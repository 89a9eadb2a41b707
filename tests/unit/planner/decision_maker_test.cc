#include "services/planner/decision_maker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/planner/plan_search.h"
#include "tests/unit/bench_domain.h"

namespace cell {

using namespace planner;
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Rules by which no agent can close the lid.
BenchDomain WithoutClosing(int64_t version) {
  return BenchDomain(BenchWith("[Closed(X)]", "[]"), version);
}

class Deciding : public testing::Test {
 protected:
  Deciding() { maker_.SetPermission(true, now_); }

  Decisions Begin(const std::string& agent, const std::string& goal = "done",
                  bool has_joined_late = false) {
    return maker_.OnEpisode({has_joined_late, agent, goal}, now_);
  }
  Decisions Sense(const std::set<std::string>& is_true) {
    return maker_.state().OnSensed(
        {++key_frame_, now_.utime, bench_.StateOf(is_true)});
  }
  void Report() {
    ArmState right{bench_.Object("right"), now_.utime, ArmState::kIdle, {}, {}};
    for (const char* part : {"bolt_1", "bolt_2", "lid"}) {
      right.reachable.push_back(bench_.Object(part));
    }
    maker_.state().OnArmState(right);
    maker_.state().OnArmState(
        {bench_.Object("left"), now_.utime, ArmState::kIdle, {}, {}});
  }
  /// Time passes; arms are idle unless asked, `is_true` is sensed.
  Decisions Run(const std::set<std::string>& is_true, int num_steps) {
    Decisions all;
    for (int i = 0; i < num_steps; ++i) {
      now_.utime += 100'000;
      now_.tick += 12;
      Report();
      Sense(is_true);
      const Decisions out = maker_.state().Decide(now_);
      all.requests.insert(all.requests.end(), out.requests.begin(),
                          out.requests.end());
      if (out.execution) all.execution = out.execution;
      if (out.plan) all.plan = out.plan;
    }
    return all;
  }

  BenchDomain bench_;
  Instant now_{1'000'000, 125};
  DecisionMaker maker_{
      bench_.rules,
      {.goals = bench_.domain.goals(), .make_solver = PlanSearch::Maker({})}};
  int64_t key_frame_ = 0;
};

const std::set<std::string> kBothIn = {"In(bolt_1, hole_1)",
                                       "In(bolt_2, hole_2)"};

TEST_F(Deciding, WatchesAPersonAndMovesNoArm) {
  Begin("person");
  const Decisions out = Sense({});
  ASSERT_TRUE(out.plan.has_value());
  EXPECT_EQ(out.plan->plan.steps.size(), 3u);
  EXPECT_THAT(Run({}, 20).requests, IsEmpty());
}

TEST_F(Deciding, ExecutesForTheRobot) {
  Begin("robot");
  EXPECT_THAT(Run({}, 3).requests, SizeIs(1));
}

TEST_F(Deciding, BeginsNothingWithoutPermission) {
  maker_.SetPermission(false, now_);
  Begin("robot");
  EXPECT_THAT(Run({}, 20).requests, IsEmpty());
  maker_.SetPermission(true, now_);
  EXPECT_THAT(Run({}, 3).requests, SizeIs(1));
}

TEST_F(Deciding, AnUnknownAgentOrGoalIsReportedAndNothingIsDone) {
  for (const auto& [agent, goal] :
       {std::pair("cat", "done"), std::pair("robot", "dome")}) {
    const Decisions out = Begin(agent, goal);
    ASSERT_THAT(out.alerts, SizeIs(1));
    EXPECT_EQ(out.alerts[0].cause, Alert::Cause::kBadInput);
    EXPECT_THAT(Run({}, 20).requests, IsEmpty());
  }
}

TEST_F(Deciding, AnEpisodeOfWhichTheStartWasLostIsTakenUp) {
  Begin("robot");
  EXPECT_TRUE(Begin("person", "done", true).sense);
}

TEST_F(Deciding, RefusesAGoalThatIsNotThereAndAnyWithoutAnEpisode) {
  EXPECT_THAT(maker_.SetGoal("one").reason(),
              HasSubstr("no episode is running"));
  Begin("person");
  EXPECT_THAT(maker_.SetGoal("two").reason(),
              HasSubstr("no goal 'two'; known: done, one"));
  EXPECT_TRUE(maker_.SetGoal("one"));
  EXPECT_EQ(Sense({}).plan->plan.steps.size(), 1u);
  maker_.OnEpisodeEnd(now_);
  EXPECT_FALSE(maker_.SetGoal("done"));
}

TEST_F(Deciding, ARuleSetOfAnotherDomainIsRefusedAndTheOldOneKept) {
  const BenchDomain other(
      BenchWith("bolt_2: bolt, lid: lid", "bolt_3: bolt, lid: lid"), 2);
  const auto answer = maker_.ReplaceRules(other.rules);
  EXPECT_THAT(answer.reason(),
              HasSubstr("objects[1]: is 'bolt_3: bolt'; must be 'bolt_2"));
  EXPECT_EQ(maker_.rules().version(), 1);
}

TEST_F(Deciding, ANewRuleSetGivesAWatchedPersonANewPlanAtOnce) {
  Begin("person");
  EXPECT_EQ(Sense(kBothIn).plan->plan.result, Plan::Result::kFound);
  const auto answer = maker_.ReplaceRules(WithoutClosing(2).rules);
  ASSERT_TRUE(answer) << answer.reason();
  ASSERT_TRUE(answer->plan.has_value());
  EXPECT_EQ(answer->plan->plan.result, Plan::Result::kNotLearned);
  EXPECT_EQ(answer->plan->key_frame, key_frame_);
  EXPECT_EQ(maker_.rules().version(), 2);
}

TEST_F(Deciding, ANewRuleSetBlamesNoActionForItsLongerPlan) {
  Begin("person");
  Sense({});
  // Each insertion succeeds in one of ten cases only.
  const BenchDomain harder(
      BenchWith("[{probability: 0.9, effects: [\"In(X, Y)\"]}]\n        noise: "
                "0.1",
                "[{probability: 0.1, effects: [\"In(X, Y)\"]}]\n        noise: "
                "0.9"),
      2);
  EXPECT_TRUE(maker_.ReplaceRules(harder.rules));
  Sense({"In(bolt_1, hole_1)"});
  DoneAction insertion{.index = 1,
                       .utime = now_.utime,
                       .pick_key_frame = 0,
                       .place_key_frame = key_frame_,
                       .objects = {bench_.Object("bolt_1")},
                       .text = "Insert"};
  EXPECT_THAT(maker_.state().OnAction(insertion).alerts, IsEmpty());
}

TEST_F(Deciding, ANewRuleSetAnswersAStandingQuestionOfTheRobot) {
  EXPECT_TRUE(maker_.ReplaceRules(WithoutClosing(2).rules));
  Begin("robot");
  const Decisions asked = Run(kBothIn, 80);
  EXPECT_THAT(asked.requests, IsEmpty());
  ASSERT_TRUE(asked.execution.has_value());
  EXPECT_EQ(asked.execution->state, ExecutionStatus::State::kStuck);
  EXPECT_TRUE(maker_.ReplaceRules(BenchDomain(kBench, 3).rules));
  const Decisions out = Run(kBothIn, 1);
  ASSERT_THAT(out.requests, SizeIs(1));
  EXPECT_EQ(out.requests[0].arguments.at("part"), bench_.Object("lid"));
  EXPECT_EQ(out.execution->state, ExecutionStatus::State::kRunning);
}

TEST_F(Deciding, WhatRunsGoesOnUnderANewRuleSet) {
  Begin("robot");
  const Decisions out = Run({}, 3);
  ASSERT_THAT(out.requests, SizeIs(1));
  EXPECT_TRUE(maker_.ReplaceRules(BenchDomain(kBench, 2).rules));
  maker_.state().OnSkillResult({out.requests[0].id, now_.utime,
                                out.requests[0].arm,
                                SkillResult::Outcome::kSucceeded, ""});
  const Decisions next = Run({"In(bolt_1, hole_1)"}, 10);
  ASSERT_FALSE(next.requests.empty());
  EXPECT_EQ(next.requests[0].arguments.at("part"), bench_.Object("bolt_2"));
}

TEST_F(Deciding, ANewActionOfANewRuleSetIsPlannedWith) {
  const std::string weld =
      "  Weld:\n    arguments: {X: lid}\n"
      "    skill: {name: insert, part: X, site: top, arm: right}\n"
      "    rules:\n      - {context: [not Closed(X)], noise: 0,\n"
      "         outcomes: [{probability: 1, effects: [Closed(X)]}]}\n";
  Begin("robot");
  EXPECT_TRUE(maker_.ReplaceRules(
      BenchDomain(BenchWith("goals:", weld + "goals:"), 2).rules));
  const Decisions out = Run({}, 3);
  ASSERT_THAT(out.requests, SizeIs(1));
  EXPECT_EQ(out.execution->action, "Weld(lid)");
}

}  // namespace
}  // namespace cell
