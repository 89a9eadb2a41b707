// Ways through joint space, among made-up obstacles and in the cell.
#include "common/arms/path_planner.h"

#include <gmock/gmock.h>

#include <random>

#include "common/arms/reach.h"
#include "common/arms/straight_line.h"
#include "common/kinematics/arm_models.h"
#include "tests/unit/stage_testing.h"

namespace cell {
namespace {

using testing::HasSubstr;

Joints At(double q1, double q2) {
  return q1 * Joints::Unit(0) + q2 * Joints::Unit(1);
}

// A wall at q1 = 0 with its only gap at q2 > 0.5.
std::optional<std::string> Wall(const Joints& q) {
  if (std::abs(q[0]) < 0.1 && q[1] < 0.5) return "it would hit the wall";
  return std::nullopt;
}

// Of an arm of the shipped cell.
const PathPlannerParams kParams(*FindArmModel("ur5"));

JointPath PlanPath(const Joints& start, const std::vector<Joints>& goals,
                   const std::vector<Joints>& vias,
                   const WhyBlockedAt& why_blocked) {
  return cell::PlanPath(start, goals, vias, why_blocked, kParams);
}
std::optional<std::string> WhyEdgeBlocked(const Joints& a, const Joints& b,
                                          const WhyBlockedAt& why_blocked) {
  return cell::WhyEdgeBlocked(a, b, why_blocked, kParams);
}

void ExpectFree(const JointPath& path, const WhyBlockedAt& why_blocked) {
  for (size_t i = 1; i < path->size(); ++i) {
    EXPECT_EQ(WhyEdgeBlocked((*path)[i - 1], (*path)[i], why_blocked),
              std::nullopt);
  }
}

TEST(PathPlanner, GoesStraightWhereItCan) {
  const JointPath path = PlanPath(At(-1, 1), {At(1, 1)}, {}, Wall);
  EXPECT_THAT(*path, testing::ElementsAre(At(-1, 1), At(1, 1)));
}

TEST(PathPlanner, TakesTheBestGoalThatIsFree) {
  const JointPath path =
      PlanPath(At(-1, 0), {At(0, 0), At(1, 0), At(-0.5, 0)}, {}, Wall);
  EXPECT_EQ(path->back(), At(-0.5, 0));
}

TEST(PathPlanner, TakesAViaIfTheStraightWayIsBlocked) {
  const JointPath path =
      PlanPath(At(-1, 0), {At(1, 0)}, {At(0, 0.3), At(0, 1.2)}, Wall);
  EXPECT_THAT(*path, testing::ElementsAre(At(-1, 0), At(0, 1.2), At(1, 0)));
}

TEST(PathPlanner, FindsTheGapAndStopsSeldom) {
  const JointPath path = PlanPath(At(-1, 0), {At(1, 0)}, {}, Wall);
  ASSERT_TRUE(path) << path.reason();
  EXPECT_EQ(path->front(), At(-1, 0));
  EXPECT_EQ(path->back(), At(1, 0));
  EXPECT_LE(path->size(), 5u);
  ExpectFree(path, Wall);
}

TEST(PathPlanner, IsAFunctionOfItsSeed) {
  PathPlannerParams params = kParams;
  const auto plan = [&] {
    return *PlanPath(At(-1, 0), {At(1, 0)}, {}, Wall, params);
  };
  const auto first = plan();
  EXPECT_EQ(plan(), first);
  params.seed = 2;
  EXPECT_NE(plan(), first);
}

TEST(PathPlanner, SaysWhatIsInTheWay) {
  EXPECT_EQ(PlanPath(At(0, 0), {At(1, 0)}, {}, Wall).reason(),
            "at the start, it would hit the wall");
  EXPECT_EQ(PlanPath(At(1, 0), {At(0, 0)}, {}, Wall).reason(),
            "at the goal, it would hit the wall");
  const auto endless = [](const Joints& q) -> std::optional<std::string> {
    if (std::abs(q[0]) < 0.1) return "it would hit the wall";
    return std::nullopt;
  };
  PathPlannerParams params = kParams;
  params.max_iterations = 100;
  const JointPath path = PlanPath(At(-1, 0), {At(1, 0)}, {}, endless, params);
  EXPECT_FALSE(path);
  EXPECT_EQ(path.reason(), "no path around: it would hit the wall");
}

TEST(PathPlanner, CarriesAPartOverOthersInTheCell) {
  const ShippedTask task;
  const ArmLayout& arm = *task.layout.FindArm("right");
  ArmScene scene(task.parts, task.layout);
  const auto standing = [](double x, double y) {
    return Eigen::Isometry3d(Eigen::Translation3d(x, y, 0.045));
  };
  scene.PutPart("shaft", standing(0.10, -0.45));
  scene.PutPart("square_peg_1", standing(0.10, -0.30));
  const Site* site = task.parts.FindSite("base.shaft");
  const auto transfers =
      Reach(scene, "right")
          .Transfers("shaft", TargetAt(*site, task.layout.pedestal.X_WP),
                     arm.home);
  ASSERT_TRUE(transfers) << transfers.reason();
  const auto& [grasp, place, is_same_configuration] = transfers->front();
  EXPECT_TRUE(is_same_configuration);
  scene.Hold("right", "shaft", grasp.X_OG.inverse());
  const WhyBlockedAt why_blocked = AskScene(
      scene, "right", {arm.home, grasp.grip, grasp.width}, {0.010, {}});
  const JointPath path =
      PlanPath(grasp.q_approach, {place.q_approach}, {}, why_blocked);
  ASSERT_TRUE(path) << path.reason();
  ExpectFree(path, why_blocked);
}

}  // namespace
}  // namespace cell
