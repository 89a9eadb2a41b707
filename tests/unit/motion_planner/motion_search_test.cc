// Where one arm can go, among what stands in the shipped cell.
#include "services/motion_planner/motion_search.h"

#include <gmock/gmock.h>

#include "common/arms/joint_trajectory.h"
#include "tests/unit/motion_testing.h"

namespace cell {

using namespace motion_planner;
namespace {

using Eigen::Vector2d;
using Kind = MotionRequest::Kind;

class MotionSearching : public testing::Test {
 protected:
  MotionSearching() { Put("round_peg_1", 0.10, -0.40); }

  void Put(const std::string& part, double x, double y) {
    cell_.poses[part] = cell_.Standing(part, x, y);
  }
  MotionPlan Find(const MotionRequest& request) const {
    return cell_.search.Find(request);
  }
  MotionPlan Grasp() const {
    const MotionPlan plan = Find(cell_.TakeRequest("round_peg_1", "right"));
    EXPECT_TRUE(plan) << plan.reason;
    return plan;
  }
  MotionRequest WayFrom(const ArmPosture& posture, const Joints& goal) const {
    MotionRequest request = cell_.Request(Kind::kWay, "right", posture);
    request.goal = goal;
    return request;
  }
  MotionRequest SetDown(const MotionPlan& grasp,
                        const Eigen::AlignedBox2d& area) const {
    MotionRequest request = cell_.Request(
        Kind::kSetDown, "right",
        {grasp.grasp.q_approach, grasp.grasp.grip, grasp.grasp.width});
    request.arms["right"].held =
        ArmScene::Held{"round_peg_1", grasp.grasp.X_OG.inverse()};
    request.area = area;
    request.is_for_other_arm = true;
    return request;
  }
  Choices<GraspChoice> GraspsOfLeft() const {
    ArmScene scene(cell_.task.parts, cell_.task.layout);
    scene.PutPart("round_peg_1", cell_.poses.at("round_peg_1"));
    return Reach(scene, "left").Grasps("round_peg_1", left_.home);
  }

  ShippedMotions cell_;
  const ArmLayout& left_ = cell_.Arm("left");
  const ArmLayout& arm_ = cell_.Arm("right");
};

// An arm stops where it would come nearer to another one than this.
TEST_F(MotionSearching, AWayFromBesideAnotherArmComesNoNearerToIt) {
  Joints beside, other;
  beside << -0.253, -2.010, 1.468, -1.231, -1.440, -0.879;
  other << -0.462, -1.484, 1.328, -1.415, -1.571, 0.136;
  const ArmPosture right{other, "two_finger_pinch", 0.046};
  ArmScene scene(cell_.task.parts, cell_.task.layout);
  scene.SetPosture("right", right);
  ArmPosture posture{beside, "two_finger_pinch", 0.055};
  constexpr double kFar = 0.02;
  const double before = scene.DistanceToOthers("left", posture, kFar);
  ASSERT_LT(before, 0.008);
  MotionRequest request = cell_.Request(Kind::kWay, "left", posture);
  request.arms["right"].posture = right;
  request.goal = left_.home;
  const MotionPlan plan = Find(request);
  ASSERT_TRUE(plan) << plan.reason;
  double nearest = kFar;
  for (size_t i = 1; i < plan.waypoints.size(); ++i) {
    for (const double share : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 0.9}) {
      posture.q = plan.waypoints[i - 1] +
                  share * (plan.waypoints[i] - plan.waypoints[i - 1]);
      nearest =
          std::min(nearest, scene.DistanceToOthers("left", posture, kFar));
    }
  }
  EXPECT_GE(nearest, before - 1e-4);
}

TEST_F(MotionSearching, WhatCanBeMovedLeavesAPartWithinReach) {
  EXPECT_TRUE(cell_.IsReachable("round_peg_1", "right"));
  // All around it; none comes between the fingers.
  Put("round_peg_2", 0.13, -0.40);
  Put("square_peg_1", 0.07, -0.40);
  Put("square_peg_2", 0.10, -0.37);
  Put("shaft", 0.10, -0.43);
  EXPECT_FALSE(Find(cell_.TakeRequest("round_peg_1", "right")));
  EXPECT_TRUE(cell_.IsReachable("round_peg_1", "right"));
  Put("round_peg_1", 0.10, -0.95);
  EXPECT_FALSE(cell_.IsReachable("round_peg_1", "right"));
}

TEST_F(MotionSearching, WhereAnotherArmStandsNowDoesNotCount) {
  const auto taken = GraspsOfLeft();
  ASSERT_TRUE(taken) << taken.reason();
  MotionRequest request = cell_.TakeRequest("round_peg_1", "right");
  request.arms["left"].posture = {taken->front().q_grasp, taken->front().grip,
                                  0.05};
  const MotionPlan plan = Find(request);
  EXPECT_TRUE(plan) << plan.reason;
  // But what it holds is gone.
  request.arms["left"].held =
      ArmScene::Held{"round_peg_1", taken->front().X_OG.inverse()};
  EXPECT_FALSE(Find(request));
}

TEST_F(MotionSearching, AWayBeginsAtThePostureAndEndsAtTheApproach) {
  const MotionPlan plan = Grasp();
  ASSERT_GE(plan.waypoints.size(), 2u);
  EXPECT_EQ(plan.waypoints.front(), arm_.home);
  EXPECT_EQ(plan.waypoints.back(), plan.grasp.q_approach);
}

TEST_F(MotionSearching, ItLeavesWhatItStandsNearTo) {
  const GraspChoice grasp = Grasp().grasp;
  for (const double gap : {0.006, 0.0}) {  // of the fingers
    const MotionPlan plan = Find(
        WayFrom({grasp.q_grasp, grasp.grip, grasp.width + gap}, arm_.home));
    ASSERT_TRUE(plan) << gap << ": " << plan.reason;
    EXPECT_EQ(plan.waypoints.back(), arm_.home);
  }
}

TEST_F(MotionSearching, WaysStayWithinTheWorkspace) {
  // Over the pedestal, from one side to the other.
  const JointTrajectory trajectory(Grasp().waypoints);
  for (double t = 0; t <= trajectory.duration(); t += 0.02) {
    EXPECT_TRUE(arm_.workspace.contains(
        GripperPose(arm_, trajectory.At(t).q).translation()))
        << t;
  }
}

TEST_F(MotionSearching, WhatItPutsDownStandsFree) {
  const MotionPlan grasp = Grasp();
  const Eigen::AlignedBox2d area = arm_.exchange;
  Put("pendulum", area.center().x(), area.center().y());
  const MotionPlan plan = Find(SetDown(grasp, area));
  ASSERT_TRUE(plan) << plan.reason;
  EXPECT_GE(PartShape::Distance(cell_.Shape("round_peg_1"), plan.target.X_WO,
                                cell_.Shape("pendulum"),
                                cell_.poses.at("pendulum"), 0.1),
            0.012 - 1e-9);
  EXPECT_TRUE(
      area.contains(Vector2d(plan.target.X_WO.translation().head<2>())));
}

TEST_F(MotionSearching, WhatItPresentsTheOtherArmCanTake) {
  const MotionPlan grasp = Grasp();
  const auto is_found = [&](double x, bool is_for_other_arm) {
    MotionRequest request =
        SetDown(grasp, {Vector2d(x, -0.45), Vector2d(x + 0.06, -0.40)});
    request.is_for_other_arm = is_for_other_arm;
    return bool(Find(request));
  };
  EXPECT_TRUE(is_found(0.10, true));
  const double beyond_left = left_.workspace.max().x() + 0.03;
  EXPECT_TRUE(is_found(beyond_left, false));
  EXPECT_FALSE(is_found(beyond_left, true));
}

TEST_F(MotionSearching, AnAnswerIsAFunctionOfItsRequest) {
  const MotionRequest request = cell_.TakeRequest("round_peg_1", "right");
  const auto encoded = [&](const MotionRequest& asked) {
    const auto message = ToMessage(Find(asked), 0);
    std::vector<uint8_t> bytes(static_cast<size_t>(message.getEncodedSize()));
    message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    return bytes;
  };
  const auto before = encoded(request);
  MotionRequest other = cell_.TakeRequest("round_peg_1", "left");
  encoded(other);
  EXPECT_EQ(encoded(request), before);
  // As it comes over the bus.
  const auto decoded =
      FromMessage(ToMessage(request), cell_.task.parts, cell_.task.layout);
  ASSERT_TRUE(decoded);
  EXPECT_EQ(encoded(*decoded), before);
}

}  // namespace
}  // namespace cell
