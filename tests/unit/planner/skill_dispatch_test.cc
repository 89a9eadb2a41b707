#include "services/planner/skill_dispatch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/bench_domain.h"

namespace cell {

using namespace planner;
namespace {

using testing::IsEmpty;
using testing::SizeIs;

class Dispatch : public testing::Test {
 protected:
  Dispatch() { Report(); }

  /// Both arms say what they run.
  void Report() {
    now_.utime += 100'000;
    now_.tick += 12;
    for (const int arm : {left_, right_}) {
      dispatch_.Update(ArmState{arm, now_.utime, runs_[arm], {}, {}});
    }
  }
  void StartInsertion() {
    dispatch_.Start(RequestFor(insert_, *bench_.rules).value(), insert_,
                    before_, now_, out_);
    runs_[right_] = out_.requests.back().id;
  }
  std::optional<EndedSkill> End(SkillResult::Outcome outcome) {
    const int64_t id = std::exchange(runs_[right_], ArmState::kIdle);
    return dispatch_.Update({id, now_.utime, right_, outcome, "it jams"});
  }

  BenchDomain bench_;
  int left_ = bench_.Object("left");
  int right_ = bench_.Object("right");
  GroundAction insert_ = bench_.Action("Insert", {"bolt_1", "hole_1"});
  State before_ = bench_.StateOf({"Reachable(right, bolt_1)"});
  Instant now_{1'000'000, 125};
  std::map<int, int64_t> runs_{{left_, ArmState::kIdle},
                               {right_, ArmState::kIdle}};
  SkillDispatch dispatch_{bench_.rules->shared_vocabulary(), {}, now_.utime};
  Decisions out_;
};

TEST_F(Dispatch, MakesOneRequestOfEachPlannedAction) {
  const auto insert = RequestFor(insert_, *bench_.rules);
  ASSERT_TRUE(insert.has_value());
  EXPECT_EQ(insert->skill, "insert");
  EXPECT_EQ(insert->arm, right_);
  EXPECT_EQ(insert->arguments.at("part"), bench_.Object("bolt_1"));
  EXPECT_EQ(insert->arguments.at("site"), bench_.Object("hole_1"));
  const auto present =
      RequestFor(bench_.Action("Present", {"lid"}), *bench_.rules);
  ASSERT_TRUE(present.has_value());
  EXPECT_EQ(present->skill, "present");
  EXPECT_EQ(present->arguments.size(), 1u);
  EXPECT_FALSE(ShareAnObject(*insert, *present));
  EXPECT_TRUE(ShareAnObject(*present, *present));
}

TEST_F(Dispatch, AnActionThatNoArmCanDoGivesNoRequest) {
  const BenchDomain by_hand(BenchWith(
      "    skill: {name: insert, part: X, site: Y, arm: right}\n", ""));
  EXPECT_FALSE(RequestFor(insert_, *by_hand.rules).has_value());
}

TEST_F(Dispatch, AnArmIsFreeUnlessItWasAskedOrSaysThatItWorks) {
  EXPECT_TRUE(dispatch_.IsFree(right_));
  StartInsertion();
  EXPECT_FALSE(dispatch_.IsFree(right_));
  EXPECT_TRUE(dispatch_.HasFreeArm());
  runs_[left_] = 4;
  Report();
  EXPECT_FALSE(dispatch_.HasFreeArm());
}

TEST_F(Dispatch, RequestsOfATickHaveIdsOfTheirOwnAndADeadline) {
  StartInsertion();
  const GroundAction present = bench_.Action("Present", {"lid"});
  dispatch_.Start(*RequestFor(present, *bench_.rules), present, before_, now_,
                  out_);
  ASSERT_THAT(out_.requests, SizeIs(2));
  EXPECT_NE(out_.requests[0].id, out_.requests[1].id);
  EXPECT_EQ(out_.requests[0].deadline_utime, now_.utime + 1'000'000);
  EXPECT_EQ(dispatch_.ShowRunning(*bench_.rules),
            "Present(lid), Insert(bolt_1, hole_1)");
}

TEST_F(Dispatch, AResultOfAnotherRequestIsNotOurs) {
  StartInsertion();
  EXPECT_FALSE(dispatch_.Update({77, now_.utime, right_, {}, ""}));
  EXPECT_FALSE(
      dispatch_.Update({out_.requests[0].id, now_.utime, left_, {}, ""}));
  EXPECT_THAT(dispatch_.running(), SizeIs(1));
}

TEST_F(Dispatch, AfterAnEndItWaitsForTheArmsToReportAgain) {
  StartInsertion();
  now_.utime += 1;
  EXPECT_TRUE(End(SkillResult::Outcome::kSucceeded)->has_succeeded);
  EXPECT_FALSE(dispatch_.HaveArmsReported());
  Report();
  EXPECT_TRUE(dispatch_.HaveArmsReported());
}

TEST_F(Dispatch, CountsFailuresAndFalseSuccessesButNotStopsAndYields) {
  for (const SkillResult::Outcome outcome :
       {SkillResult::Outcome::kStopped, SkillResult::Outcome::kYielded}) {
    StartInsertion();
    EXPECT_FALSE(End(outcome)->counts);
    Report();
  }
  EXPECT_EQ(dispatch_.failures().Of(insert_), nullptr);
  for (const SkillResult::Outcome outcome :
       {SkillResult::Outcome::kFailed, SkillResult::Outcome::kRefused,
        SkillResult::Outcome::kSucceeded}) {
    EXPECT_THAT(dispatch_.failures().Blocked(), IsEmpty());
    StartInsertion();
    EXPECT_TRUE(End(outcome)->counts);
    Report();
  }
  EXPECT_THAT(dispatch_.failures().Blocked(), testing::ElementsAre(insert_));
}

TEST_F(Dispatch, AnArmThatWasStoppedIsToGoFreeUntilItHasOrHasFailedThrice) {
  StartInsertion();
  End(SkillResult::Outcome::kStopped);
  Report();
  ASSERT_TRUE(dispatch_.HasArmToFree());
  for (int i = 0; i < 3; ++i) {
    out_ = {};
    dispatch_.StartGoingFree(now_, out_);
    dispatch_.StartGoingFree(now_, out_);  // it is asked once
    ASSERT_THAT(out_.requests, SizeIs(1));
    EXPECT_EQ(out_.requests[0].skill, "go_free");
    runs_[right_] = out_.requests[0].id;
    EXPECT_TRUE(dispatch_.HasArmToFree());
    End(SkillResult::Outcome::kFailed);
    Report();
  }
  EXPECT_FALSE(dispatch_.HasArmToFree());
}

TEST_F(Dispatch, ARequestThatAnIdleArmHasForgottenIsLost) {
  StartInsertion();
  runs_[right_] = ArmState::kIdle;
  for (int i = 0; i < 4; ++i) {
    Report();
    EXPECT_THAT(dispatch_.EndLostRequests(), IsEmpty());
  }
  Report();
  const auto lost = dispatch_.EndLostRequests();
  ASSERT_THAT(lost, SizeIs(1));
  EXPECT_EQ(lost[0].reason, "the arm restarted and lost the request");
  EXPECT_TRUE(dispatch_.HasArmToFree());
  EXPECT_EQ(dispatch_.failures().Of(insert_)->count, 1);
}

TEST_F(Dispatch, ASlowSkillIsNotLostEvenIfItsResultComesLate) {
  StartInsertion();
  for (int i = 0; i < 100; ++i) {
    Report();
    EXPECT_THAT(dispatch_.EndLostRequests(), IsEmpty());
  }
  const int64_t id = std::exchange(runs_[right_], ArmState::kIdle);
  Report();  // idle already
  EXPECT_THAT(dispatch_.EndLostRequests(), IsEmpty());
  EXPECT_TRUE(dispatch_.Update({id, now_.utime, right_, {}, ""}).has_value());
}

}  // namespace
}  // namespace cell
