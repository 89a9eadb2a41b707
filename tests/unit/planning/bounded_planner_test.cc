#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "common/planning/planner.h"
#include "common/planning/rollout.h"
#include "tests/unit/planning/ppddl_task.h"
#include "tests/unit/small_ppddl.h"

namespace cell::planning {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

TEST(BoundedPlanner, TheBestOfTwoWaysIsFound) {
  // Loading takes 2 attempts on average; then drive, cross once, unload.
  const Plan bridge = PlanOf(TaskOf(kCourier, kDelivery));
  EXPECT_NEAR(bridge.probability.low, 0.75, 1e-9);
  EXPECT_NEAR(bridge.probability.high, 0.75, 1e-9);
  EXPECT_NEAR(bridge.expected_actions, 5, 1e-9);
  EXPECT_TRUE(bridge.is_shortest);
  ASSERT_EQ(bridge.course.size(), 4u);
  EXPECT_EQ(bridge.course[0].name, "load(x, depot)");
  EXPECT_EQ(bridge.course[0].probability, 0.5);
  EXPECT_EQ(bridge.course[2].name, "cross(m, t)");

  // With a certain way from m besides, the bridge is tried first.
  const Plan road = PlanOf(TaskOf(
      kCourier,
      With(With(kDelivery, "m t - town", "m n o t - town"), "(bridge m t)",
           "(bridge m t) (road m n) (road n o) (road o t)")));
  EXPECT_EQ(road.probability.low, 1);
  EXPECT_NEAR(road.expected_actions, 2 + 1 + (1 + 0.25 * 3) + 1, 1e-9);
}

TEST(BoundedPlanner, AlternativesHaveIntervals) {
  Planner::Params params;
  params.solve_alternatives = true;
  const GroundTask task =
      Propositional(2,
                    "(:action safe :effect (probabilistic 0.9 (p0) 0.1 (p1)))"
                    "(:action risky :precondition (not (p1)) :effect "
                    "(probabilistic 0.5 (p0) 0.5 (p1)))",
                    "", "(and (p0) (not (p1)))");
  const Plan plan = PlanOf(task, params);
  ASSERT_EQ(plan.alternatives.size(), 2u);
  EXPECT_EQ(plan.alternatives[0].name, "safe()");
  EXPECT_NEAR(plan.alternatives[0].probability.low, 0.9, 1e-8);
  EXPECT_NEAR(plan.alternatives[1].probability.high, 0.5, 1e-8);
}

TEST(BoundedPlanner, TheReasonIsGivenWithoutAPlan) {
  const Plan none =
      PlanOf(TaskOf(kCourier, With(kDelivery, "(bridge m t)", "(broken)")));
  EXPECT_EQ(none.status, Plan::Status::kNoPlan);
  EXPECT_THAT(none.reason, HasSubstr("no sequence of actions"));
  EXPECT_EQ(none.probability, (Interval{0, 0}));

  const Plan reached =
      PlanOf(TaskOf(kCourier, With(kDelivery, "(in x depot)", "(in x t)")));
  EXPECT_EQ(reached.status, Plan::Status::kGoalReached);
  EXPECT_THAT(reached.course, IsEmpty());

  Planner::Params params;
  params.max_expansions = 1;
  const Plan undecided = PlanOf(TaskOf(kCourier, kDelivery), params);
  EXPECT_EQ(undecided.status, Plan::Status::kUndecided);
  EXPECT_EQ(undecided.probability, (Interval{0, 1}));
  EXPECT_THAT(undecided.reason, HasSubstr("within the budget"));
}

TEST(BoundedPlanner, AnUpperBoundIsNotCaughtInAnEndComponent) {
  // p0 and p1 can be swapped for ever; the only way on succeeds with 0.3.
  const Plan plan = PlanOf(Propositional(
      5,
      "(:action f :precondition (p0) :effect (and (p1) (not (p0))))"
      "(:action g :precondition (p1) :effect (and (p0) (not (p1))))"
      "(:action h :precondition (and (p0) (not (p4))) :effect (and (p4) "
      "(probabilistic 0.3 (p3))))",
      "(p0)", "(p3)"));
  EXPECT_NEAR(plan.probability.high, 0.3, 1e-9);
  EXPECT_NEAR(plan.probability.low, 0.3, 1e-9);
}

TEST(BoundedPlanner, ExecutedPlansReachTheGoalAsOftenAsPromised) {
  const auto model = std::make_shared<GroundModel>(TaskOf(kCourier, kDelivery));
  Planner planner(model, {});
  planner.Find(model->initial());
  const Rollouts rollouts =
      RollOut(*model, planner, model->initial(), 10'000, 1);
  EXPECT_EQ(rollouts, RollOut(*model, planner, model->initial(), 10'000, 1));
  // Four standard deviations.
  EXPECT_NEAR(rollouts.num_reached / 10'000.0, 0.75, 4 * 0.00433);
  EXPECT_NEAR(rollouts.mean_actions, 5, 4 * 0.0163);
}

TEST(BoundedPlanner, OutsideItsPlanItDoesNothing) {
  const auto model = std::make_shared<GroundModel>(TaskOf(kCourier, kDelivery));
  Planner planner(model, {});
  EXPECT_EQ(planner.ActionIn(model->initial()), std::nullopt);
  planner.Find(model->initial());
  const auto action = planner.ActionIn(model->initial());
  ASSERT_TRUE(action.has_value());
  EXPECT_EQ(model->ActionName(*action), "load(x, depot)");
  EXPECT_EQ(planner.ActionIn(
                model->Pack(std::vector<bool>(model->task().atoms.size()))),
            std::nullopt);
}

TEST(BoundedPlanner, WrongStatesAndTasksThrow) {
  const auto model = std::make_shared<GroundModel>(TaskOf(kCourier, kDelivery));
  const std::vector<uint64_t> long_state(2);
  EXPECT_THROW(Planner(model, {}).Find(long_state), std::invalid_argument);
  EXPECT_THROW(model->Pack({}), std::invalid_argument);
  GroundTask task{{{"p", {}}}, {false}, {}, {}};
  task.actions.push_back({"f", {{{1, true}}, {}}, {}});
  EXPECT_THROW(GroundModel{task}, std::invalid_argument);
  task.actions = {{"f", {}, {{0.7, {}}, {0.7, {}}}}};
  EXPECT_THROW(GroundModel{task}, std::invalid_argument);
}

}  // namespace
}  // namespace cell::planning
