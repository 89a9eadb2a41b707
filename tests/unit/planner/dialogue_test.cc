#include "services/planner/dialogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cell {

using namespace planner;
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr int64_t kPatienceUs = 5'000'000;  // [us]

class DialogueTest : public testing::Test {
 protected:
  static Instant At(int64_t utime) { return {utime, 0}; }
  Decisions Ask(int64_t utime) {
    Decisions out;
    dialogue_.Ask(question_, asked_, At(utime), out);
    return out;
  }

  Dialogue dialogue_{kPatienceUs};
  ExecutionStatus question_{.state = ExecutionStatus::State::kStuck,
                            .text = "please help"};
  State asked_ = State(2);
  State other_ = [] {
    State state(2);
    state.Set(1, Truth::kTrue);
    return state;
  }();
};

TEST_F(DialogueTest, IsPatientForAWhileAndAgainAfterAnArmHasStarted) {
  EXPECT_TRUE(dialogue_.IsPatient(At(1'000)));
  EXPECT_TRUE(dialogue_.IsPatient(At(kPatienceUs)));
  EXPECT_FALSE(dialogue_.IsPatient(At(kPatienceUs + 1'000)));
  dialogue_.OnStart();
  EXPECT_TRUE(dialogue_.IsPatient(At(kPatienceUs + 2'000)));
}

TEST_F(DialogueTest, ReportsAQuestionAndItsAlertOnce) {
  const Decisions out = Ask(7);
  EXPECT_EQ(out.execution, question_);
  ASSERT_THAT(out.alerts, SizeIs(1));
  EXPECT_EQ(out.alerts[0].cause, Alert::Cause::kStuck);
  EXPECT_EQ(out.alerts[0].text, "The robot asks: please help");
  EXPECT_TRUE(dialogue_.is_asking());
  const Decisions again = Ask(8);
  EXPECT_FALSE(again.execution.has_value());
  EXPECT_THAT(again.alerts, IsEmpty());
}

TEST_F(DialogueTest, ThePersonIsAtWorkFromAChangeUntilTheStateStays) {
  Ask(0);
  EXPECT_FALSE(dialogue_.IsPersonAtWork(asked_, At(1)));
  EXPECT_TRUE(dialogue_.IsPersonAtWork(other_, At(2)));
  State third = other_;
  third.Set(0, Truth::kTrue);
  EXPECT_TRUE(dialogue_.IsPersonAtWork(third, At(kPatienceUs)));
  EXPECT_TRUE(dialogue_.IsPersonAtWork(third, At(2 * kPatienceUs - 1)));
  EXPECT_FALSE(dialogue_.IsPersonAtWork(third, At(2 * kPatienceUs)));
  EXPECT_FALSE(dialogue_.IsPersonAtWork(other_, At(2 * kPatienceUs)));
}

TEST_F(DialogueTest, APersonWhoWasNotAskedIsNotAtWork) {
  EXPECT_FALSE(dialogue_.IsPersonAtWork(other_, At(1)));
}

TEST_F(DialogueTest, OnlyAnActionBegunAfterTheQuestionAnswersIt) {
  EXPECT_FALSE(dialogue_.OnAction({.pick_utime = 50}));
  Ask(100);
  EXPECT_FALSE(dialogue_.OnAction({.pick_utime = 99}));
  EXPECT_TRUE(dialogue_.IsPersonAtWork(other_, At(110)));
  EXPECT_TRUE(dialogue_.OnAction({.pick_utime = 100}));
  EXPECT_FALSE(dialogue_.IsPersonAtWork(other_, At(120)));
}

TEST_F(DialogueTest, ForgetsItsQuestionWithTheGoal) {
  Ask(0);
  dialogue_.OnGoal();
  EXPECT_FALSE(dialogue_.is_asking());
  EXPECT_FALSE(dialogue_.IsPersonAtWork(other_, At(1)));
}

}  // namespace
}  // namespace cell
