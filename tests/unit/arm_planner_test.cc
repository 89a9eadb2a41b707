// Where one arm can go, among what stands in the shipped cell.
#include "services/robot_arm/arm_planner.h"

#include <gmock/gmock.h>

#include "tests/unit/stage_testing.h"

namespace cell {

using namespace robot_arm;
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector2d;
using testing::Contains;
using testing::Not;

class ArmPlanning : public testing::Test {
 protected:
  ArmPlanning() { See(); }

  // Upright on the table.
  Isometry3d Standing(const std::string& part, double x, double y) const {
    const double bottom = Shape(part).LowestZ(Isometry3d::Identity());
    return Isometry3d(Translation3d(x, y, 0.0005 - bottom));
  }
  PartShape Shape(const std::string& part) const {
    return PartShape(*task_.parts.Find(part));
  }
  void See() {
    planner_.SetParts(poses_);
    for (size_t i = 0; i <= poses_.size(); ++i) planner_.RefreshReachable();
  }
  GraspChoice Grasp(const std::string& part) const {
    const auto planned = planner_.PlanPick(part, std::nullopt, arm_.home);
    if (const auto* reason = std::get_if<std::string>(&planned)) {
      ADD_FAILURE() << *reason;
      return {};
    }
    return std::get<GraspChoice>(planned);
  }

  /// Of the peg, by the other arm, alone with it.
  auto GraspsOfLeft() const {
    ArmScene scene(task_.parts, task_.layout);
    scene.PutPart("round_peg_1", poses_.at("round_peg_1"));
    return Reach(scene, "left").Grasps("round_peg_1", left_.home);
  }

  ShippedTask task_;
  const ArmLayout& left_ = *task_.layout.FindArm("left");
  const ArmLayout& arm_ = *task_.layout.FindArm("right");
  ArmPlanner planner_{
      {"right", task_.layout, task_.parts,
       SkillSettings::FromConfig(ShippedDeployment().OfTask("skills.yaml"),
                                 task_.parts)}};
  std::map<std::string, Isometry3d> poses_ = {
      {"base", task_.layout.pedestal.X_WP},
      {"round_peg_1", Standing("round_peg_1", 0.10, -0.40)}};
};

TEST_F(ArmPlanning, WhatCanBeMovedLeavesAPartWithinReach) {
  EXPECT_THAT(planner_.Reachable(), Contains("round_peg_1"));
  // All around it; none comes between the fingers.
  poses_["round_peg_2"] = Standing("round_peg_2", 0.13, -0.40);
  poses_["square_peg_1"] = Standing("square_peg_1", 0.07, -0.40);
  poses_["square_peg_2"] = Standing("square_peg_2", 0.10, -0.37);
  poses_["shaft"] = Standing("shaft", 0.10, -0.43);
  See();
  EXPECT_TRUE(std::holds_alternative<std::string>(
      planner_.PlanPick("round_peg_1", std::nullopt, arm_.home)));
  EXPECT_THAT(planner_.Reachable(), Contains("round_peg_1"));
  poses_["round_peg_1"] = Standing("round_peg_1", 0.10, -0.95);
  See();
  EXPECT_THAT(planner_.Reachable(), Not(Contains("round_peg_1")));
}

TEST_F(ArmPlanning, WhereAnotherArmStandsNowDoesNotCount) {
  const auto taken = GraspsOfLeft();
  ASSERT_TRUE(taken) << taken.reason;
  planner_.SetOther("left", {taken.list[0].q_grasp, "", 0.05}, false);
  poses_["round_peg_1"] = Standing("round_peg_1", 0.103, -0.40);
  See();
  EXPECT_THAT(planner_.Reachable(), Contains("round_peg_1"));
  // It sets out, and waits where it would meet the other.
  const GraspChoice grasp = Grasp("round_peg_1");
  const auto way = planner_.PlanTransit(arm_.home, grasp.q_approach,
                                        grasp.opening, grasp.grip);
  EXPECT_TRUE(std::holds_alternative<JointTrajectory>(way))
      << std::get<std::string>(way);
  EXPECT_TRUE(planner_.MeetsOther({arm_.home, grasp.grip, grasp.opening},
                                  {grasp.q_grasp}));
}

TEST_F(ArmPlanning, APartInAPersonsHandIsOutOfReach) {
  const Eigen::Vector3d p_W = poses_.at("round_peg_1").translation();
  planner_.SetHands({p_W + Eigen::Vector3d(0, 0, 0.24)});
  EXPECT_TRUE(planner_.IsHandNear(p_W));
  EXPECT_THAT(planner_.Reachable(), Contains("round_peg_1"));
  planner_.SetHands({p_W});
  EXPECT_THAT(planner_.Reachable(), Not(Contains("round_peg_1")));
}

TEST_F(ArmPlanning, PeoplesHandsAtWorkAreInTheWay) {
  const GraspChoice grasp = Grasp("round_peg_1");
  const ArmPosture home{arm_.home, grasp.grip, grasp.opening};
  const ArmPosture there{grasp.q_approach, grasp.grip, grasp.opening};
  const Eigen::Vector3d p_WG =
      GripperPose(arm_, grasp.q_approach).translation();
  const auto at = [&](double x) {
    planner_.SetHands({p_WG + Eigen::Vector3d(x, 0, 0)});
  };
  at(0.06);
  at(0.07);
  EXPECT_TRUE(planner_.MeetsPerson(home, {there.q}));
  EXPECT_TRUE(planner_.MeetsPerson(there, {std::nullopt}));
  EXPECT_FALSE(planner_.MeetsPerson(home, {std::nullopt}));
  at(0.07);  // it rests
  EXPECT_FALSE(planner_.MeetsPerson(home, {there.q}));
  at(0.5);
  EXPECT_FALSE(planner_.MeetsPerson(home, {there.q}));
  // A hand that rests, but holds something.
  poses_["shaft"] = Isometry3d(Translation3d(p_WG));
  See();
  at(0.5);
  EXPECT_FALSE(planner_.MeetsPerson(home, {there.q}));
  at(0);
  at(0);
  EXPECT_TRUE(planner_.MeetsPerson(home, {there.q}));
  // But the arm itself holds it.
  planner_.SetHeld(HeldPart{"shaft", Isometry3d::Identity(), grasp.grip, 0.01});
  at(0);
  EXPECT_FALSE(planner_.MeetsPerson(home, {there.q}));
}

TEST_F(ArmPlanning, ItLeavesWhatItStandsNearTo) {
  EXPECT_FALSE(planner_.IsNearSomething(arm_.home));
  const GraspChoice grasp = Grasp("round_peg_1");
  EXPECT_TRUE(planner_.IsNearSomething(grasp.q_grasp));
  for (const double gap : {0.006, 0.0}) {  // of the fingers
    const auto way = planner_.PlanTransit(grasp.q_grasp, arm_.home,
                                          grasp.width + gap, grasp.grip);
    ASSERT_TRUE(std::holds_alternative<JointTrajectory>(way))
        << gap << ": " << std::get<std::string>(way);
    EXPECT_EQ(std::get<JointTrajectory>(way).goal(), arm_.home);
  }
}

TEST_F(ArmPlanning, WaysStayWithinTheWorkspace) {
  // Over the pedestal, from one side to the other.
  const GraspChoice grasp = Grasp("round_peg_1");
  const auto way = planner_.PlanTransit(arm_.home, grasp.q_approach,
                                        grasp.opening, grasp.grip);
  ASSERT_TRUE(std::holds_alternative<JointTrajectory>(way))
      << std::get<std::string>(way);
  const auto& trajectory = std::get<JointTrajectory>(way);
  for (double t = 0; t <= trajectory.duration(); t += 0.02) {
    EXPECT_TRUE(arm_.workspace.contains(
        GripperPose(arm_, trajectory.At(t).q).translation()))
        << t;
  }
}

TEST_F(ArmPlanning, WhatAnotherArmGripsGoesWithItsHand) {
  const auto taken = GraspsOfLeft();
  ASSERT_TRUE(taken) << taken.reason;
  const GraspChoice& grasp = taken.list.front();
  const auto is_there = [&] {
    return std::holds_alternative<GraspChoice>(
        planner_.PlanPick("round_peg_1", std::nullopt, arm_.home));
  };
  planner_.SetOther("left", {grasp.q_grasp, grasp.grip, grasp.width}, true);
  // Tracks still show it where it lay.
  planner_.SetOther("left", {left_.home, grasp.grip, grasp.width}, true);
  See();
  EXPECT_FALSE(is_there());
  planner_.SetOther("left", {left_.home, grasp.grip, grasp.opening}, false);
  EXPECT_TRUE(is_there());
}

TEST_F(ArmPlanning, ItMeetsAnotherArmSoonerIfThatOneMoves) {
  const auto over_table = [](const ArmLayout& arm, double x) {
    return TrackPose(arm, Isometry3d(Translation3d(x, -0.40, 0.20)), arm.home)
        .value();
  };
  const ArmPosture now{over_table(arm_, 0.30), "two_finger_pinch", 0.02};
  const Joints ahead = over_table(arm_, 0.21);
  const Joints into = over_table(arm_, 0.10);
  const ArmPosture other{over_table(left_, 0.05), "two_finger_pinch", 0.02};
  planner_.SetOther("left", other, false);
  EXPECT_FALSE(planner_.MeetsOther(now, {ahead}));
  EXPECT_TRUE(planner_.MeetsOther(now, {into}));
  // Away is always free.
  EXPECT_FALSE(planner_.MeetsOther({into, now.grip, now.opening}, {now.q}));
  ArmPosture moved = other;
  moved.q[5] += 0.01;
  planner_.SetOther("left", moved, false);
  EXPECT_TRUE(planner_.MeetsOther(now, {ahead}));
  planner_.SetOther("left", moved, false);
  EXPECT_FALSE(planner_.MeetsOther(now, {ahead}));
  EXPECT_FALSE(planner_.MeetsOther(now, {ahead}));
}

TEST_F(ArmPlanning, WhatItPutsDownStandsFree) {
  const GraspChoice grasp = Grasp("round_peg_1");
  const Eigen::AlignedBox2d area = arm_.exchange;
  poses_["pendulum"] =
      Standing("pendulum", area.center().x(), area.center().y());
  See();
  planner_.SetHeld(
      HeldPart{"round_peg_1", grasp.X_OG.inverse(), grasp.grip, grasp.width});
  const auto found = planner_.FindFreePlace(area, ArmPlanner::Taker::kOtherArm,
                                            grasp.q_approach);
  ASSERT_TRUE(std::holds_alternative<PlaceTarget>(found))
      << std::get<std::string>(found);
  const PlaceTarget& target = std::get<PlaceTarget>(found);
  EXPECT_GE(PartShape::Distance(Shape("round_peg_1"), target.X_WO,
                                Shape("pendulum"), poses_.at("pendulum"), 0.1),
            0.012 - 1e-9);
  EXPECT_TRUE(
      area.contains(Eigen::Vector2d(target.X_WO.translation().head<2>())));
}

TEST_F(ArmPlanning, WhatItPresentsTheOtherArmCanTake) {
  using Taker = ArmPlanner::Taker;
  const GraspChoice grasp = Grasp("round_peg_1");
  planner_.SetHeld(
      HeldPart{"round_peg_1", grasp.X_OG.inverse(), grasp.grip, grasp.width});
  const auto is_found = [&](double x, Taker taker) {
    const Eigen::AlignedBox2d area{Vector2d(x, -0.45),
                                   Vector2d(x + 0.06, -0.40)};
    return std::holds_alternative<PlaceTarget>(
        planner_.FindFreePlace(area, taker, grasp.q_approach));
  };
  EXPECT_TRUE(is_found(0.10, Taker::kOtherArm));
  const double beyond_left = left_.workspace.max().x() + 0.03;
  EXPECT_TRUE(is_found(beyond_left, Taker::kAnyone));
  EXPECT_FALSE(is_found(beyond_left, Taker::kOtherArm));
}

}  // namespace
}  // namespace cell
