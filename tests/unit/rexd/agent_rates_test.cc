#include "common/rexd/agent_rates.h"

#include <gtest/gtest.h>

#include "common/rexd/rexd.h"
#include "tests/unit/rexd/placing_task.h"

namespace cell::rexd {
namespace {

using namespace rules;

class WithRatesOfPlacing : public testing::Test {
 protected:
  WithRatesOfPlacing() {
    World::Set(
        &placed_,
        world_.PlaceOf(*world_.symbols().Find("placed"), place_.arguments),
        true);
  }

  const RexdTask task_ = PlacingTask();
  const World& world_ = *task_.world;
  const GroundAct place_{*world_.symbols().Find("place"), {0}};
  WorldState placed_ = task_.initial;  // after the action has succeeded
};

TEST_F(WithRatesOfPlacing, CountsTheExperiencesOfOneAgentOnly) {
  std::vector<Experience> experiences(
      4, Experience{task_.initial, place_, task_.initial});
  experiences[0].after = placed_;
  const AgentRules robot = WithRatesOf(experiences, task_.truth, world_);
  EXPECT_DOUBLE_EQ(robot.rules.rules[0].outcomes[0].probability, 0.25);
  EXPECT_DOUBLE_EQ(robot.rules.rules[0].noise, 0.75);
  EXPECT_EQ(robot.counts[0], 4);
  // Nothing was closed.
  EXPECT_EQ(robot.rules.rules[1], task_.truth.rules[1]);
  EXPECT_EQ(robot.counts[1], 0);
}

TEST_F(WithRatesOfPlacing, DemonstrationsThatNeverFailDoNotRaiseTheRobotsRate) {
  RexD learner(task_, {});
  for (int i = 0; i < 10; ++i) {
    learner.Observe({task_.initial, place_, placed_}, true);
    learner.Observe({task_.initial, place_, i < 2 ? placed_ : task_.initial});
  }
  const AgentRules robot = learner.RobotRules();
  const auto coverage =
      FindCoverage(robot.rules, place_, task_.initial, world_);
  ASSERT_TRUE(coverage);
  double p = 0;
  for (const Outcome& outcome : coverage->rule->outcomes) {
    if (Apply(outcome, coverage->binding, task_.initial, world_) == placed_) {
      p += outcome.probability;
    }
  }
  EXPECT_DOUBLE_EQ(p, 0.2);
}

}  // namespace
}  // namespace cell::rexd
