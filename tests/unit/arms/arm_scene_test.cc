// What an arm may hit, and how it is said.
#include "common/arms/arm_scene.h"

#include <gmock/gmock.h>

#include <random>

#include "common/arms/straight_line.h"
#include "tests/unit/stage_testing.h"

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using testing::AnyOf;
using testing::Eq;
using testing::HasSubstr;
using testing::Not;
using testing::Optional;

class ArmSceneTest : public testing::Test {
 protected:
  static Isometry3d Down(double x, double y, double z) {
    return Isometry3d(Eigen::Translation3d(x, y, z));
  }

  const ArmLayout& Arm(const std::string& name) const {
    return *task_.layout.FindArm(name);
  }

  // The posture in home's branch with the gripper down at a place.
  ArmPosture At(const std::string& arm, double x, double y, double z,
                double opening = 0.06) const {
    const auto q = TrackPose(Arm(arm), Down(x, y, z), Arm(arm).home);
    EXPECT_TRUE(q.has_value()) << x << " " << y << " " << z;
    return {q.value_or(Arm(arm).home), "two_finger_pinch", opening};
  }

  std::optional<std::string> WhyBlocked(const ArmPosture& posture,
                                        const ClearanceRule& rule = {}) const {
    return scene_.WhyBlocked("right", posture, rule);
  }

  ShippedTask task_;
  ArmScene scene_{task_.parts, task_.layout};
};

TEST_F(ArmSceneTest, HomesAreFree) {
  for (const ArmLayout& arm : task_.layout.arms) {
    EXPECT_EQ(scene_.WhyBlocked(arm.name, HomePosture(arm), {0.05, {}}),
              std::nullopt);
  }
}

TEST_F(ArmSceneTest, NamesTheFingerAndThePartInItsWay) {
  const ArmPosture over = At("right", 0.10, -0.40, 0.03, 0.0);
  EXPECT_EQ(WhyBlocked(over), std::nullopt);
  scene_.PutPart("shaft", Down(0.10, -0.40, 0.045));
  EXPECT_THAT(WhyBlocked(over),
              Optional(AnyOf(Eq("gripper_right.finger_1 would hit shaft"),
                             Eq("gripper_right.finger_2 would hit shaft"))));
  scene_.RemovePart("shaft");
  EXPECT_EQ(WhyBlocked(over), std::nullopt);
}

TEST_F(ArmSceneTest, OpenFingersStraddleThePart) {
  scene_.PutPart("shaft", Down(0.10, -0.40, 0.045));
  EXPECT_EQ(WhyBlocked(At("right", 0.10, -0.40, 0.077, 0.07), {0.002, {}}),
            std::nullopt);
  EXPECT_NE(WhyBlocked(At("right", 0.10, -0.40, 0.077, 0.04), {0.002, {}}),
            std::nullopt);
}

TEST_F(ArmSceneTest, AllowedPairsMayTouch) {
  scene_.PutPart("shaft", Down(0.10, -0.40, 0.045));
  const ArmPosture closed = At("right", 0.10, -0.40, 0.077, 0.04);
  EXPECT_EQ(WhyBlocked(closed, {0.002, {{"gripper_right", "shaft"}}}),
            std::nullopt);
  EXPECT_EQ(WhyBlocked(closed, {0.002, {{"shaft", "gripper_right"}}}),
            std::nullopt);
  EXPECT_THAT(
      WhyBlocked(closed, {0.002, {{"gripper_right.finger_1", "shaft"}}}),
      Optional(Eq("gripper_right.finger_2 would hit shaft")));
}

TEST_F(ArmSceneTest, NamesTheTable) {
  EXPECT_THAT(WhyBlocked(At("right", 0.10, -0.40, 0.005)),
              Optional(HasSubstr("would hit the table")));
  EXPECT_EQ(WhyBlocked(At("right", 0.10, -0.40, 0.005),
                       {0.01, {{"gripper_right", "table"}}}),
            std::nullopt);
}

TEST_F(ArmSceneTest, ClearanceIsADistance) {
  // Fingers end 12 mm below G.
  const ArmPosture near = At("right", 0.10, -0.40, 0.020);
  EXPECT_EQ(WhyBlocked(near, {0.0079, {}}), std::nullopt);
  EXPECT_NE(WhyBlocked(near, {0.0081, {}}), std::nullopt);
}

TEST_F(ArmSceneTest, ThePedestalAndTheFixedPartStand) {
  EXPECT_THAT(WhyBlocked(At("right", 0, 0, 0.16)),
              Optional(AnyOf(HasSubstr("base"), HasSubstr("pedestal"))));
  scene_.RemovePart("base");
  EXPECT_EQ(WhyBlocked(At("right", 0, 0, 0.17)), std::nullopt);
  EXPECT_THAT(WhyBlocked(At("right", 0, 0, 0.145)),
              Optional(HasSubstr("would hit pedestal")));
}

TEST_F(ArmSceneTest, OneArmIsInTheWayOfTheOther) {
  const ArmPosture right = At("right", 0.05, -0.40, 0.10);
  EXPECT_EQ(WhyBlocked(right), std::nullopt);
  scene_.SetPosture("left", At("left", 0.05, -0.40, 0.12));
  EXPECT_THAT(WhyBlocked(right), Optional(HasSubstr("_left")));
  EXPECT_EQ(WhyBlocked(right, {0.01,
                               {{"gripper_left", "gripper_right"},
                                {"gripper_left", "arm_right"},
                                {"arm_left", "gripper_right"},
                                {"arm_left", "arm_right"}}}),
            std::nullopt);
}

TEST_F(ArmSceneTest, WhatIsHeldGoesAlongAndMeetsThings) {
  scene_.PutPart("round_peg_1", Down(0.10, -0.40, 0.045));
  const ArmPosture over = At("right", 0.10, -0.40, 0.20, 0.03);
  EXPECT_EQ(WhyBlocked(over), std::nullopt);
  // Its lower end 77 mm below G.
  scene_.Hold("right", "shaft", Down(0, 0, -0.032));
  EXPECT_EQ(WhyBlocked(over), std::nullopt);
  EXPECT_THAT(WhyBlocked(At("right", 0.10, -0.40, 0.165, 0.03), {0.002, {}}),
              Optional(Eq("shaft would hit round_peg_1")));
  EXPECT_FALSE(scene_.PoseOf("shaft").has_value());
  scene_.LetGo("right");
  EXPECT_EQ(WhyBlocked(At("right", 0.10, -0.40, 0.165, 0.03), {0.002, {}}),
            std::nullopt);
}

TEST_F(ArmSceneTest, WhatTheOtherArmHoldsIsInTheWay) {
  scene_.SetPosture("left", At("left", -0.10, -0.30, 0.25, 0.03));
  const ArmPosture under = At("right", 0.06, -0.30, 0.18, 0.0);
  EXPECT_EQ(WhyBlocked(under), std::nullopt);
  // Its far end to the right of the gripper.
  Isometry3d X_GO = Down(-0.05, 0, -0.02);
  X_GO.linear() =
      Eigen::AngleAxisd(-std::acos(0.0), Vector3d::UnitZ()).toRotationMatrix();
  scene_.Hold("left", "pendulum", X_GO);
  EXPECT_THAT(WhyBlocked(under), Optional(HasSubstr("would hit pendulum")));
}

TEST_F(ArmSceneTest, TheDistanceToOtherArmsCountsWhatEitherHolds) {
  constexpr double kCutoff = 0.30;
  const auto distance = [&] {
    return scene_.DistanceToOthers("right", At("right", 0.20, -0.40, 0.20),
                                   kCutoff);
  };
  EXPECT_EQ(distance(), kCutoff);
  scene_.SetPosture("left", At("left", 0.00, -0.40, 0.20));
  const double empty = distance();
  EXPECT_GT(empty, 0);
  EXPECT_LT(empty, 0.20);
  // 50 mm out to the side of the hand.
  Isometry3d X_GO = Down(-0.10, 0, -0.02);
  scene_.Hold("right", "round_peg_1", X_GO);
  const double one = distance();
  EXPECT_LT(one, empty);
  X_GO.translation().x() = 0.10;
  scene_.Hold("left", "round_peg_2", X_GO);
  EXPECT_EQ(distance(), 0);
  // It agrees with what may not be.
  scene_.LetGo("left");
  const ArmPosture there = At("right", 0.20, -0.40, 0.20);
  EXPECT_TRUE(WhyBlocked(there, {one + 1e-3, {}}).has_value());
  EXPECT_EQ(WhyBlocked(there, {one - 1e-3, {}}), std::nullopt);
}

TEST_F(ArmSceneTest, WhatAllFingersAreAtIsGrasped) {
  const ArmPosture closed = At("right", 0.10, -0.40, 0.06, 0.03);
  EXPECT_EQ(scene_.FindGrasped("right", closed), std::nullopt);
  scene_.PutPart("round_peg_2", Down(0.15, -0.40, 0.045));  // at one of them
  EXPECT_EQ(scene_.FindGrasped("right", closed), std::nullopt);
  scene_.PutPart("round_peg_1", Down(0.10, -0.40, 0.045));
  EXPECT_EQ(scene_.FindGrasped("right", closed), "round_peg_1");
}

TEST_F(ArmSceneTest, AnArmMayHitItself) {
  // The forearm folded back until the hand is at the upper arm.
  ArmPosture folded = HomePosture(Arm("right"));
  folded.q[1] = -1.57;
  folded.q[2] = 2.9;
  folded.q[3] = -0.2;
  EXPECT_THAT(WhyBlocked(folded), Optional(HasSubstr("would hit arm_right")));
}

TEST_F(ArmSceneTest, AWristInTheOpenIsFreeWhileItsHandPointsOutwards) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> angle(-3.1, 3.1), half(-1.0, 1.0);
  for (int i = 0; i < 300; ++i) {
    ArmPosture raised = HomePosture(Arm("right"));
    raised.q << 0, -1.9, 0.6, angle(random), half(random), angle(random);
    EXPECT_EQ(WhyBlocked(raised), std::nullopt) << raised.q.transpose();
  }
}

TEST_F(ArmSceneTest, MissesNothingAndSeesNothingThatIsNotThere) {
  Stage stage(task_);
  std::vector<std::pair<PartShape, Isometry3d>> others;
  for (const Part& part : task_.parts.parts()) {
    scene_.PutPart(part.name, stage.PoseOf(part.name));
    others.emplace_back(PartShape(part), stage.PoseOf(part.name));
  }
  const ArmLayout& left = Arm("left");
  const std::vector<Part> left_bodies = BodyPartsOf(left);
  const auto X_W_left = BodyPosesOf(left, HomePosture(left));
  for (size_t i = 0; i < left_bodies.size(); ++i) {
    others.emplace_back(PartShape(left_bodies[i]), X_W_left[i]);
  }
  std::vector<PartShape> bodies;
  for (const Part& body : BodyPartsOf(Arm("right"))) bodies.emplace_back(body);

  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> x(-0.35, 0.45), y(-0.6, 0.3),
      z(0.02, 0.3);
  const double clearance = 0.015;
  ClearanceRule rule{
      clearance, {{"pedestal", "arm_right"}, {"pedestal", "gripper_right"}}};
  int num_asked = 0, num_blocked = 0;
  for (int i = 0; i < 400; ++i) {
    const auto q = TrackPose(
        Arm("right"), Down(x(random), y(random), z(random)), Arm("right").home);
    if (!q || Arm("right").model->IsNearSingularity(*q)) continue;
    const ArmPosture posture{*q, "two_finger_pinch", 0.06};
    const auto X_W = BodyPosesOf(Arm("right"), posture);
    bool is_blocked = false;
    for (size_t b = ArmModel::kFirstLinkBody; b < bodies.size(); ++b) {
      is_blocked = is_blocked || bodies[b].LowestZ(X_W[b]) < clearance;
      for (size_t c = 0; c < b; ++c) {
        is_blocked = is_blocked ||
                     (Arm("right").model->MayCollide(c, b) &&
                      PartShape::Distance(bodies[b], X_W[b], bodies[c], X_W[c],
                                          1) < ArmScene::kSelfClearance);
      }
      for (const auto& [shape, X_WO] : others) {
        is_blocked = is_blocked || PartShape::Distance(bodies[b], X_W[b], shape,
                                                       X_WO, 1) < clearance;
      }
    }
    ++num_asked;
    num_blocked += is_blocked ? 1 : 0;
    const auto why = WhyBlocked(posture, rule);
    EXPECT_EQ(why.has_value(), is_blocked) << why.value_or("nothing");
  }
  EXPECT_GT(num_blocked, 40);
  EXPECT_GT(num_asked - num_blocked, 40);
}

TEST_F(ArmSceneTest, NeighboursOfASeatedPartAreWhatItTouches) {
  const Isometry3d X_WB = task_.layout.pedestal.X_WP;
  const Site* site = task_.parts.FindSite("base.shaft");
  EXPECT_THAT(scene_.Neighbours("shaft", X_WB * site->X_HS, 0.005),
              testing::UnorderedElementsAre("base", "pedestal"));
  EXPECT_THAT(scene_.Neighbours("shaft", Down(0.1, -0.4, 0.045), 0.005),
              testing::ElementsAre("table"));
}

TEST_F(ArmSceneTest, CopiesAreIndependent) {
  ArmScene copy = scene_;
  copy.PutPart("shaft", Down(0.10, -0.40, 0.045));
  EXPECT_TRUE(copy.PoseOf("shaft").has_value());
  EXPECT_FALSE(scene_.PoseOf("shaft").has_value());
}

TEST_F(ArmSceneTest, UnknownNamesAreTheCallersBug) {
  EXPECT_THROW(scene_.PutPart("spoon", Down(0, 0, 0)), std::invalid_argument);
  EXPECT_THROW(scene_.SetPosture("middle", {}), std::invalid_argument);
  EXPECT_THROW(WhyBlocked({Arm("right").home, "no_such_grip", 0}),
               std::invalid_argument);
}

}  // namespace
}  // namespace cell
