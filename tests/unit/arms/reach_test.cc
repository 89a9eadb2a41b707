// Ways to take parts and to place them.
#include "common/arms/reach.h"

#include <gmock/gmock.h>

#include "common/geometry/degree.h"
#include "tests/unit/stage_testing.h"

namespace cell {
namespace {

using Eigen::Isometry3d;
using testing::HasSubstr;

class ReachTest : public testing::Test {
 protected:
  static Isometry3d Standing(double x, double y, double z = 0.045) {
    return Isometry3d(Eigen::Translation3d(x, y, z));
  }
  const ArmLayout& Arm(const std::string& name) const {
    return *task_.layout.FindArm(name);
  }
  Choices<GraspChoice> Grasps(const std::string& arm, const std::string& part) {
    return Reach(scene_, arm).Grasps(part, Arm(arm).home);
  }
  PlaceTarget At(const std::string& site) const {
    return TargetAt(*task_.parts.FindSite(site), task_.layout.pedestal.X_WP);
  }

  ShippedTask task_;
  ArmScene scene_{task_.parts, task_.layout};
};

TEST_F(ReachTest, EveryGraspBringsTheGripperWhereItSays) {
  const Isometry3d X_WO = Standing(0.10, -0.40);
  scene_.PutPart("shaft", X_WO);
  for (const char* arm : {"left", "right"}) {
    const auto grasps = Grasps(arm, "shaft");
    ASSERT_TRUE(grasps) << grasps.reason();
    double last_cost = 0;
    for (const GraspChoice& grasp : *grasps) {
      const Isometry3d X_WG = X_WO * grasp.X_OG;
      EXPECT_TRUE(GripperPose(Arm(arm), grasp.q_grasp).isApprox(X_WG, 1e-6));
      EXPECT_TRUE(
          GripperPose(Arm(arm), grasp.q_approach)
              .isApprox(X_WG * Eigen::Translation3d(0, 0, 0.080), 1e-6));
      EXPECT_LE((grasp.q_approach - grasp.q_grasp).norm(), 1.0);
      EXPECT_GE(grasp.cost, last_cost);
      last_cost = grasp.cost;
    }
  }
}

TEST_F(ReachTest, SaysThatAPartIsOutOfReach) {
  scene_.PutPart("shaft", Standing(-0.38, -0.64));
  EXPECT_THAT(Grasps("right", "shaft").reason(),
              testing::MatchesRegex("outside the arm's workspace: x .* mm, .* "
                                    "to .* mm are allowed"));
  scene_.PutPart("shaft", Standing(-0.358, -0.64));
  EXPECT_THAT(Grasps("right", "shaft").reason(),
              HasSubstr("outside the arm's workspace: x"))
      << "too near to the border";
  scene_.PutPart("shaft", Standing(-0.34, -0.64));
  EXPECT_EQ(Grasps("right", "shaft").reason(), "out of reach");
  EXPECT_EQ(Grasps("right", "head").reason(),
            "head has no known pose to grasp it at");
}

TEST_F(ReachTest, NamesWhatIsInTheWay) {
  scene_.PutPart("shaft", Standing(0.10, -0.40));
  for (const auto& [x, y] : {std::pair{0.148, -0.40}, {0.052, -0.40}}) {
    scene_.PutPart(x > 0.1 ? "square_peg_1" : "square_peg_2", Standing(x, y));
  }
  // Fingers fit in from the other sides only.
  const auto grasps = Grasps("right", "shaft");
  ASSERT_TRUE(grasps) << grasps.reason();
  scene_.PutPart("round_peg_1", Standing(0.10, -0.352));
  scene_.PutPart("round_peg_2", Standing(0.10, -0.448));
  EXPECT_THAT(Grasps("right", "shaft").reason(),
              testing::MatchesRegex("gripper_right.* would hit .*peg_."));
}

TEST_F(ReachTest, TakesTheGripThatTheHandKnows) {
  scene_.PutPart("head", Standing(0.10, -0.40, 0));
  const auto right = Grasps("right", "head");
  ASSERT_TRUE(right) << right.reason();
  EXPECT_EQ(right->front().grip, "three_finger_ball");
  const auto left = Grasps("left", "head");
  ASSERT_TRUE(left) << left.reason();
  EXPECT_EQ(left->front().grip, "two_finger_pinch");
}

TEST_F(ReachTest, AHandTooSmallTakesNothing) {
  CellLayout layout = task_.layout;
  for (ArmLayout& arm : layout.arms) arm.hand.max_opening = 0.05;
  ArmScene scene(task_.parts, layout);
  scene.PutPart("head", Standing(0.10, -0.40, 0));
  EXPECT_EQ(Reach(scene, "left").Grasps("head", Arm("left").home).reason(),
            "too wide for the hand");
}

TEST_F(ReachTest, PlacesAPartInAnyWayThatLooksTheSame) {
  const Grasp& grasp = task_.parts.Find("square_peg_1")->grasps.front();
  const PlaceTarget target = At("base.square_1");
  const auto places =
      Reach(scene_, "right")
          .Placements("square_peg_1", grasp.X_OG.inverse(), "two_finger_pinch",
                      grasp.width, target, Arm("right").home);
  ASSERT_TRUE(places) << places.reason();
  bool is_turned = false;
  for (const PlaceChoice& place : *places) {
    const Isometry3d X_WG = place.X_WO * grasp.X_OG;
    EXPECT_TRUE(GripperPose(Arm("right"), place.q_place).isApprox(X_WG, 1e-6));
    EXPECT_TRUE(
        GripperPose(Arm("right"), place.q_approach)
            .isApprox(Eigen::Translation3d(0, 0, target.approach) * X_WG,
                      1e-6));
    const double turn = Eigen::AngleAxisd(target.X_WO.linear().transpose() *
                                          place.X_WO.linear())
                            .angle();
    EXPECT_NEAR(std::remainder(turn, 90 * kDegree), 0, 1e-6);
    is_turned = is_turned || turn > 0.1;
  }
  EXPECT_TRUE(is_turned);
}

TEST_F(ReachTest, AnOccupiedSiteIsNamed) {
  scene_.PutPart("shaft", At("base.shaft").X_WO);
  const Grasp& grasp = task_.parts.Find("round_peg_1")->grasps.front();
  PlaceTarget target = At("base.shaft");
  target.X_WO.translation().z() += 0.06;
  scene_.PutPart("round_peg_2",
                 Eigen::Translation3d(0, 0, 0.1) * At("base.shaft").X_WO);
  const auto places =
      Reach(scene_, "right")
          .Placements("round_peg_1", grasp.X_OG.inverse(), "two_finger_pinch",
                      grasp.width, target, Arm("right").home);
  EXPECT_FALSE(places);
  EXPECT_THAT(places.reason(), HasSubstr("would hit round_peg_2"));
}

TEST_F(ReachTest, LeavesRoomForTurningAfterwards) {
  const Grasp& grasp = task_.parts.Find("round_peg_1")->grasps.front();
  PlaceTarget target = At("base.round_1");
  for (const double turn : {-405 * kDegree, 405 * kDegree}) {
    target.turn = turn;
    const auto places =
        Reach(scene_, "right")
            .Placements("round_peg_1", grasp.X_OG.inverse(), "two_finger_pinch",
                        grasp.width, target, Arm("right").home);
    ASSERT_TRUE(places) << places.reason();
    for (const PlaceChoice& place : *places) {
      // The flange looks down: turning by joint 6 is turning the other way.
      Joints turned = place.q_place;
      turned[5] -= turn;
      EXPECT_TRUE(turned.isApprox(place.q_turned, 1e-12));
      EXPECT_TRUE(Arm("right").model->IsWithinLimits(turned));
      const Isometry3d X_WG = GripperPose(Arm("right"), place.q_place);
      const Eigen::AngleAxisd about(turn, Eigen::Vector3d::UnitZ());
      EXPECT_TRUE(GripperPose(Arm("right"), turned)
                      .linear()
                      .isApprox(about * X_WG.linear(), 1e-9));
    }
  }
  target.turn = 800 * kDegree;
  EXPECT_THAT(
      Reach(scene_, "right")
          .Placements("round_peg_1", grasp.X_OG.inverse(), "two_finger_pinch",
                      grasp.width, target, Arm("right").home)
          .reason(),
      testing::StartsWith("beyond a joint limit: joint 6 at "));
}

TEST_F(ReachTest, TransfersStayInOneConfigurationWhereTheyCan) {
  scene_.PutPart("pendulum", Standing(0.10, -0.45, 0));
  const auto transfers =
      Reach(scene_, "right")
          .Transfers("pendulum", At("base.pendulum"), Arm("right").home);
  ASSERT_TRUE(transfers) << transfers.reason();
  const ArmModel& model = *Arm("right").model;
  for (const TransferChoice& transfer : *transfers) {
    EXPECT_EQ(transfer.is_same_configuration,
              model.ConfigurationOf(transfer.grasp.q_grasp) ==
                  model.ConfigurationOf(transfer.place.q_place));
  }
  EXPECT_TRUE(transfers->front().is_same_configuration);
}

TEST_F(ReachTest, AStraightLineStaysInItsConfigurationAndSaysWhereItEnds) {
  const ArmLayout& arm = Arm("right");
  const Isometry3d X_WG = GripperPose(arm, arm.home);
  const auto line =
      TrackLine(arm, arm.home, Eigen::Translation3d(0, -0.1, -0.1) * X_WG);
  ASSERT_TRUE(line) << line.reason();
  for (const Joints& q : *line) {
    EXPECT_EQ(arm.model->ConfigurationOf(q),
              arm.model->ConfigurationOf(arm.home));
    EXPECT_TRUE(GripperPose(arm, q).linear().isApprox(X_WG.linear(), 1e-6));
  }
  EXPECT_FALSE(TrackLine(arm, arm.home, Eigen::Translation3d(-2, 0, 0) * X_WG));
}

}  // namespace
}  // namespace cell
