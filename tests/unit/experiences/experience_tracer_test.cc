#include "common/experiences/experience_tracer.h"

#include <gtest/gtest.h>

#include "tests/unit/experiences/cranfield_rules.h"

namespace cell {
namespace {

class ExperienceTracerTest : public testing::Test {
 protected:
  ExperienceTracerTest() {
    first_ = task_.Start();
    second_ =
        task_.Do(first_, "PlaceRoundPeg", {"round_peg_1", "base.round_1"});
    third_ = task_.Do(second_, "PlaceRoundPeg", {"shaft", "base.shaft"});
    tracer_.Sensed(0, 0, first_);
    tracer_.Sensed(2, 20, second_);
    tracer_.Sensed(5, 50, third_);
  }

  CranfieldRules task_;
  ExperienceTracer tracer_{task_.world};
  State first_{0}, second_{0}, third_{0};
  GroundAction peg_ =
      task_.Ground("PlaceRoundPeg", {"round_peg_1", "base.round_1"});
  GroundAction shaft_ = task_.Ground("PlaceRoundPeg", {"shaft", "base.shaft"});
};

TEST_F(ExperienceTracerTest, IsFromBeforeThePickUpToThePlacement) {
  tracer_.Done(shaft_, 3, 5);
  tracer_.Done(peg_, 1, 2);
  const auto experiences = tracer_.Experiences();
  ASSERT_EQ(experiences.size(), 2U);
  EXPECT_EQ(experiences[0], task_.world.ToExperience(first_, peg_, second_));
  EXPECT_EQ(experiences[1], task_.world.ToExperience(second_, shaft_, third_));
}

TEST_F(ExperienceTracerTest, LeavesOutManipulationsAtTheSameTime) {
  tracer_.Done(peg_, 1, 3);
  tracer_.Moved(2, 5);
  EXPECT_TRUE(tracer_.Experiences().empty());
}

TEST_F(ExperienceTracerTest, LeavesOutWhatWasNotSensed) {
  tracer_.Done(peg_, 3, 4);    // no state at key frame 4
  tracer_.Done(shaft_, 0, 2);  // none before key frame 0
  EXPECT_TRUE(tracer_.Experiences().empty());
}

TEST_F(ExperienceTracerTest, TurnsTheReverseAround) {
  tracer_.Reversed(shaft_, 3, 5);
  const auto experiences = tracer_.Experiences();
  ASSERT_EQ(experiences.size(), 1U);
  EXPECT_EQ(experiences[0], task_.world.ToExperience(third_, shaft_, second_));
}

TEST_F(ExperienceTracerTest, AnAttemptChangesNothing) {
  tracer_.Attempted(shaft_, 10, 30);
  tracer_.Attempted(shaft_, 21, 49);  // nothing was sensed meanwhile
  const auto experiences = tracer_.Experiences();
  ASSERT_EQ(experiences.size(), 1U);
  EXPECT_EQ(experiences[0], task_.world.ToExperience(first_, shaft_, first_));
}

TEST_F(ExperienceTracerTest, AFailedSkillIsOneFromRequestToResult) {
  tracer_.Failed(shaft_, 10, 19);
  tracer_.Failed(peg_, 10, 60);  // nothing was sensed after it
  const auto experiences = tracer_.Experiences();
  ASSERT_EQ(experiences.size(), 1U);
  EXPECT_EQ(experiences[0], task_.world.ToExperience(first_, shaft_, second_));
}

}  // namespace
}  // namespace cell
