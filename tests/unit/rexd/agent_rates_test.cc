#include "common/rexd/agent_rates.h"

#include <gtest/gtest.h>

#include "common/rexd/rexd.h"
#include "tests/unit/rexd/placing_task.h"

namespace cell::rexd {
namespace {

using namespace rules;

TEST(WithRatesOf, CountsTheExperiencesOfOneAgentOnly) {
  const RexdTask task = PlacingTask();
  const World& world = *task.world;
  const GroundAct place{*world.symbols().Find("place"), {0}};
  WorldState placed = task.initial;
  World::Set(&placed,
             world.PlaceOf(*world.symbols().Find("placed"), place.arguments),
             true);
  std::vector<Experience> experiences(
      4, Experience{task.initial, place, task.initial});
  experiences[0].after = placed;
  const AgentRules robot = WithRatesOf(experiences, task.truth, world);
  EXPECT_DOUBLE_EQ(robot.rules.rules[0].outcomes[0].probability, 0.25);
  EXPECT_DOUBLE_EQ(robot.rules.rules[0].noise, 0.75);
  EXPECT_EQ(robot.counts[0], 4);
  // Nothing was closed.
  EXPECT_EQ(robot.rules.rules[1], task.truth.rules[1]);
  EXPECT_EQ(robot.counts[1], 0);
}

TEST(WithRatesOf, DemonstrationsThatNeverFailDoNotRaiseTheRobotsRate) {
  const RexdTask task = PlacingTask();
  const World& world = *task.world;
  const GroundAct place{*world.symbols().Find("place"), {0}};
  WorldState placed = task.initial;
  World::Set(&placed,
             world.PlaceOf(*world.symbols().Find("placed"), place.arguments),
             true);
  RexD learner(task, {});
  for (int i = 0; i < 10; ++i) {
    learner.Observe({task.initial, place, placed}, true);
    learner.Observe({task.initial, place, i < 2 ? placed : task.initial});
  }
  const AgentRules robot = learner.RobotRules();
  const auto coverage = FindCoverage(robot.rules, place, task.initial, world);
  ASSERT_TRUE(coverage);
  double p = 0;
  for (const Outcome& outcome : coverage->rule->outcomes) {
    if (Apply(outcome, coverage->binding, task.initial, world) == placed) {
      p += outcome.probability;
    }
  }
  EXPECT_DOUBLE_EQ(p, 0.2);
}

}  // namespace
}  // namespace cell::rexd
