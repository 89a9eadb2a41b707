// What an arm knows of its surroundings, in the shipped cell.
#include "services/robot_arm/scene_monitor.h"

#include <gmock/gmock.h>

#include "tests/unit/motion_testing.h"

namespace cell {

using namespace robot_arm;
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

class SceneMonitoring : public testing::Test {
 protected:
  SceneMonitoring() {
    cell_.poses["round_peg_1"] = cell_.Standing("round_peg_1", 0.10, -0.40);
    monitor_.SetParts(cell_.poses);
  }
  GraspChoice Grasp(const std::string& arm) const {
    const MotionPlan plan =
        cell_.search.Find(cell_.TakeRequest("round_peg_1", arm));
    EXPECT_TRUE(plan) << plan.reason;
    return plan.grasp;
  }

  ShippedMotions cell_;
  const ArmLayout& left_ = cell_.Arm("left");
  const ArmLayout& arm_ = cell_.Arm("right");
  SceneMonitor monitor_{
      {"right", cell_.task.layout, cell_.task.parts, 0.008, {}}};
};

TEST_F(SceneMonitoring, APartAtAPersonsFingersIsInHand) {
  const Vector3d p_W = cell_.poses.at("round_peg_1").translation();
  monitor_.SetHands({p_W + Vector3d(0, 0, 0.24)});
  EXPECT_TRUE(monitor_.IsHandNear(p_W));
  EXPECT_FALSE(monitor_.IsInHand("round_peg_1"));
  monitor_.SetHands({p_W});
  EXPECT_TRUE(monitor_.IsInHand("round_peg_1"));
}

TEST_F(SceneMonitoring, PeoplesHandsAtWorkAreInTheWay) {
  const GraspChoice grasp = Grasp("right");
  const ArmPosture home{arm_.home, grasp.grip, grasp.opening};
  const ArmPosture there{grasp.q_approach, grasp.grip, grasp.opening};
  const Vector3d p_WG = GripperPose(arm_, grasp.q_approach).translation();
  const auto at = [&](double x) {
    monitor_.SetHands({p_WG + Vector3d(x, 0, 0)});
  };
  at(0.06);
  at(0.07);
  EXPECT_TRUE(monitor_.WouldCollideWithPerson(home, {there.q}));
  EXPECT_TRUE(monitor_.WouldCollideWithPerson(there, {std::nullopt}));
  EXPECT_FALSE(monitor_.WouldCollideWithPerson(home, {std::nullopt}));
  at(0.07);  // it rests
  EXPECT_FALSE(monitor_.WouldCollideWithPerson(home, {there.q}));
  at(0.5);
  EXPECT_FALSE(monitor_.WouldCollideWithPerson(home, {there.q}));
  // A hand that rests, but holds something.
  cell_.poses["shaft"] = Isometry3d(Translation3d(p_WG));
  monitor_.SetParts(cell_.poses);
  at(0.5);
  EXPECT_FALSE(monitor_.WouldCollideWithPerson(home, {there.q}));
  at(0);
  at(0);
  EXPECT_TRUE(monitor_.WouldCollideWithPerson(home, {there.q}));
  // But the arm itself holds it.
  monitor_.SetHeld(HeldPart{"shaft", Isometry3d::Identity(), grasp.grip, 0.01});
  at(0);
  EXPECT_FALSE(monitor_.WouldCollideWithPerson(home, {there.q}));
}

TEST_F(SceneMonitoring, AtAGraspSomethingIsNear) {
  EXPECT_FALSE(monitor_.IsNearSomething(arm_.home));
  const MotionPlan plan =
      cell_.search.Find(cell_.TakeRequest("round_peg_1", "right"));
  const Joints q_grasp =
      TrackPose(arm_, cell_.poses.at("round_peg_1") * plan.grasp.X_OG,
                plan.grasp.q_approach)
          .value();
  EXPECT_TRUE(monitor_.IsNearSomething(q_grasp));
}

TEST_F(SceneMonitoring, WhatAnotherArmGripsGoesWithItsHand) {
  const GraspChoice grasp = Grasp("left");
  const auto is_there = [&] {
    MotionRequest request =
        monitor_.MakeRequest(MotionRequest::Kind::kGrasp, HomePosture(arm_));
    request.part = "round_peg_1";
    return bool(cell_.search.Find(request));
  };
  const Joints q_grasp =
      TrackPose(left_, cell_.poses.at("round_peg_1") * grasp.X_OG,
                grasp.q_approach)
          .value();
  monitor_.SetOther("left", {q_grasp, grasp.grip, grasp.width}, true);
  // Tracks still show it where it lay.
  monitor_.SetOther("left", {left_.home, grasp.grip, grasp.width}, true);
  monitor_.SetParts(cell_.poses);
  EXPECT_FALSE(is_there());
  monitor_.SetOther("left", {left_.home, grasp.grip, grasp.opening}, false);
  EXPECT_TRUE(is_there());
}

TEST_F(SceneMonitoring, ItMeetsAnotherArmSoonerIfThatOneMoves) {
  const auto over_table = [](const ArmLayout& arm, double x) {
    return TrackPose(arm, Isometry3d(Translation3d(x, -0.40, 0.20)), arm.home)
        .value();
  };
  const ArmPosture now{over_table(arm_, 0.30), "two_finger_pinch", 0.02};
  const Joints ahead = over_table(arm_, 0.21);
  const Joints into = over_table(arm_, 0.10);
  const ArmPosture other{over_table(left_, 0.05), "two_finger_pinch", 0.02};
  monitor_.SetOther("left", other, false);
  EXPECT_FALSE(monitor_.WouldCollideWithArm(now, {ahead}));
  EXPECT_TRUE(monitor_.WouldCollideWithArm(now, {into}));
  // Away is always free.
  EXPECT_FALSE(
      monitor_.WouldCollideWithArm({into, now.grip, now.opening}, {now.q}));
  ArmPosture moved = other;
  moved.q[5] += 0.01;
  monitor_.SetOther("left", moved, false);
  EXPECT_TRUE(monitor_.WouldCollideWithArm(now, {ahead}));
  monitor_.SetOther("left", moved, false);
  EXPECT_FALSE(monitor_.WouldCollideWithArm(now, {ahead}));
}

}  // namespace
}  // namespace cell
