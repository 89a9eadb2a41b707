// A robot that learns while it does a task: what it asks, tries and keeps.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "services/planner/execute.h"
#include "services/planner/plan_search.h"
#include "tests/unit/planner/learning_bench.h"

namespace cell {

using namespace planner;
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int64_t kStepUs = 96'000;

class LearningExecution : public testing::Test {
 protected:
  void Begin(bool needs_confirmation = false) {
    ExecutionParams params;
    params.exploration = bench_.Exploring();
    params.exploration->needs_confirmation = needs_confirmation;
    execute_ =
        std::make_unique<Execute>(bench_.rules, bench_.bench.GoalOf("done"),
                                  PlanSearch::Maker({}), params, true, now_);
  }
  /// Time passes; arms are done at once with going home.
  void Step(int num_steps) {
    for (int i = 0; i < num_steps; ++i) {
      now_.utime += kStepUs;
      now_.tick += 12;
      Report("left", left_);
      Report("right", right_);
      if (is_sensing_) Sense();
      const Decisions out = execute_->Decide(now_);
      is_sensing_ = out.sense;
      if (out.execution) told_ = *out.execution;
      for (const SkillRequest& request : out.requests) Take(request);
    }
  }
  void Sense() {
    const Decisions out =
        execute_->OnSensed({++key_frame_, now_.utime, state_});
    kept_.insert(kept_.end(), out.experiences.begin(), out.experiences.end());
  }
  void Take(const SkillRequest& request) {
    const bool is_right = bench_.bench.Name(request.arm) == "right";
    if (request.skill == "go_home") {
      ++num_home_;
      return End(request.arm, request.id);
    }
    (is_right ? right_ : left_) = request.id;
    requests_.push_back(request);
  }
  void End(int arm, int64_t id,
           SkillResult::Outcome outcome = SkillResult::Outcome::kSucceeded) {
    execute_->OnSkillResult({id, now_.utime, arm, outcome, "it slipped"});
    (bench_.bench.Name(arm) == "right" ? right_ : left_) = ArmState::kIdle;
  }
  void Report(const std::string& name, int64_t request) {
    ArmState report{bench_.bench.Object(name),
                    now_.utime,
                    request,
                    std::nullopt,
                    {},
                    SkillsOfBench()};
    if (name == "right") {
      for (const char* part : {"bolt_1", "bolt_2", "bolt_3", "lid"}) {
        report.reachable.push_back(bench_.bench.Object(part));
      }
    }
    execute_->OnArmState(report);
  }
  /// The library keeps it.
  void Learn(const TaskExperience& experience) {
    bench_.Learn(experience);
    execute_->SetExperiences(bench_.knowledge.experiences());
    execute_->SetRules(bench_.rules);
  }
  bool IsAsking() const {
    return told_.state == ExecutionStatus::State::kStuck;
  }

  LearningBench bench_;
  State state_ = bench_.Start();
  Instant now_{1'000'000, 125};
  std::unique_ptr<Execute> execute_;
  ExecutionStatus told_;
  std::vector<SkillRequest> requests_;
  std::vector<TaskExperience> kept_;
  int64_t left_ = ArmState::kIdle, right_ = ArmState::kIdle;
  int64_t key_frame_ = 0;
  int num_home_ = 0;
  bool is_sensing_ = false;
};

TEST_F(LearningExecution, AsksToBeShownWhatNoRuleBringsAbout) {
  Begin();
  Step(100);
  ASSERT_TRUE(IsAsking());
  EXPECT_THAT(told_.text, HasSubstr("please show me one of these"));
  EXPECT_THAT(told_.unlearned, SizeIs(3));
  EXPECT_EQ(num_home_, 2) << "arms leave room first";
  EXPECT_THAT(requests_, IsEmpty());
}

TEST_F(LearningExecution, DoesWhatWasShownAtHalfSpeedOnce) {
  Begin();
  Step(100);
  Learn(bench_.Inserted("bolt_3", "box.hole_1", state_));
  Step(10);
  ASSERT_THAT(requests_, SizeIs(1));
  EXPECT_TRUE(requests_[0].is_careful);
  state_ = bench_.With(state_, "In(bolt_1, box.hole_1)");
  End(requests_[0].arm, requests_[0].id);
  Step(10);
  ASSERT_THAT(kept_, SizeIs(1));
  EXPECT_EQ(kept_[0].agent, Agent::kRobot);
  Learn(kept_[0]);
  Step(130);
  ASSERT_THAT(requests_, SizeIs(2)) << told_.text;
  EXPECT_FALSE(requests_[1].is_careful);
}

TEST_F(LearningExecution, WaitsForTheOperatorBeforeWhatArmsNeverDid) {
  Begin(true);
  Learn(bench_.Inserted("bolt_3", "box.hole_1", state_));
  Step(20);
  EXPECT_THAT(requests_, IsEmpty());
  ASSERT_TRUE(IsAsking());
  EXPECT_THAT(told_.text, HasSubstr("cell confirm Insert"));
  execute_->Confirm("Close");
  Step(20);
  EXPECT_THAT(requests_, IsEmpty());
  execute_->Confirm("Insert");
  Step(20);
  EXPECT_THAT(requests_, SizeIs(1));
}

TEST_F(LearningExecution, AFailedTrialIsAnExperienceInWhichNothingChanges) {
  Begin();
  Learn(bench_.Inserted("bolt_3", "box.hole_1", state_));
  Step(10);
  ASSERT_THAT(requests_, SizeIs(1));
  End(requests_[0].arm, requests_[0].id, SkillResult::Outcome::kFailed);
  Step(10);
  ASSERT_THAT(kept_, SizeIs(1));
  EXPECT_EQ(kept_[0].before, kept_[0].after);
  EXPECT_EQ(kept_[0].action, "Insert");
}

TEST_F(LearningExecution, WhatWasStoppedIsNoExperience) {
  Begin();
  Learn(bench_.Inserted("bolt_3", "box.hole_1", state_));
  Step(10);
  ASSERT_THAT(requests_, SizeIs(1));
  End(requests_[0].arm, requests_[0].id, SkillResult::Outcome::kYielded);
  Step(10);
  EXPECT_THAT(kept_, IsEmpty());
}

TEST_F(LearningExecution, WithoutLearningNothingIsKeptOrTried) {
  execute_ = std::make_unique<Execute>(
      bench_.rules, bench_.bench.GoalOf("done"), PlanSearch::Maker({}),
      ExecutionParams{}, true, now_);
  bench_.Learn(bench_.Inserted("bolt_3", "box.hole_1", state_));
  execute_->SetRules(bench_.rules);
  Step(100);
  EXPECT_TRUE(IsAsking());
  EXPECT_THAT(requests_, IsEmpty());
  EXPECT_EQ(num_home_, 0);
}

}  // namespace
}  // namespace cell
