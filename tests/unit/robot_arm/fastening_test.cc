// Which parts are held by the site that they are at: an arm that grips such a
// part releases it and does not carry it away.
#include "services/robot_arm/fastening.h"

#include <gmock/gmock.h>

#include "cell/arm_report_t.hpp"
#include "cell/arm_state_t.hpp"
#include "cell/asked_skill_t.hpp"
#include "cell/motion_permit_t.hpp"
#include "cell/skill_result_t.hpp"
#include "cell/tracks_t.hpp"
#include "common/bus/decode.h"
#include "common/bus/stepper.h"
#include "common/kinematics/joint_values.h"
#include "common/scene/track.h"
#include "common/skills/skill_arguments.h"
#include "services/robot_arm/robot_arm.h"
#include "services/robot_arm/tool_kinematics.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace robot_arm;
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

Isometry3d Above(double z, double x = 0, double tilt = 0) {
  return Translation3d(x, 0, z) * AngleAxisd(tilt, Vector3d::UnitX());
}

class FasteningTest : public testing::Test {
 protected:
  FasteningTest() { stage_.SeatAll(); }

  std::map<std::string, Isometry3d> Poses() const {
    std::map<std::string, Isometry3d> poses;
    for (const Part& part : task_.parts.parts()) {
      poses[part.name] = stage_.PoseOf(part.name);
    }
    return poses;
  }
  std::string SiteOf(const std::string& part) const {
    const Site* site = FindHoldingSite(part, task_.parts, Poses());
    return site == nullptr ? "" : site->name;
  }

  ShippedTask task_;
  Stage stage_{task_};
};

TEST_F(FasteningTest, SitesHoldWhatIsSeated) {
  EXPECT_EQ(SiteOf("round_peg_2"), "base.round_2");
  EXPECT_EQ(SiteOf("pendulum"), "base.pendulum");
  EXPECT_EQ(SiteOf("head"), "pendulum.head");
  EXPECT_EQ(SiteOf("face_plate"), "base.face_plate");
}

TEST_F(FasteningTest, APartHalfwayIntoItsHoleIsNotHeldByIt) {
  stage_.Seat("square_peg_1", "base.square_1", Above(0.015));
  EXPECT_EQ(SiteOf("square_peg_1"), "");
  stage_.Seat("square_peg_1", "base.square_1", Above(0, 0, 0.1));
  EXPECT_EQ(SiteOf("square_peg_1"), "");
}

TEST_F(FasteningTest, AThreadHoldsFromWhereItTakesHold) {
  stage_.Seat("head", "pendulum.head", Above(0.008));
  EXPECT_EQ(SiteOf("head"), "pendulum.head");
  stage_.Seat("head", "pendulum.head",
              Above(0.004) * AngleAxisd(2, Vector3d::UnitZ()));
  EXPECT_EQ(SiteOf("head"), "pendulum.head");
  stage_.Seat("head", "pendulum.head", Above(0.015));
  EXPECT_EQ(SiteOf("head"), "");
  stage_.Seat("head", "pendulum.head", Above(0.004, 0.01));
  EXPECT_EQ(SiteOf("head"), "");
}

TEST_F(FasteningTest, ThereIsNoSiteWithoutTheTracksOfPartAndHost) {
  auto poses = Poses();
  poses.erase("pendulum");
  EXPECT_EQ(FindHoldingSite("head", task_.parts, poses), nullptr);
  EXPECT_EQ(FindHoldingSite("pendulum", task_.parts, poses), nullptr);
  EXPECT_EQ(FindHoldingSite("nothing", task_.parts, poses), nullptr);
}

/// The right arm's service starts with its fingers closed on the head, which is
/// at `X_SO` of its site.
class ArmThatHoldsTheHead : public FasteningTest {
 protected:
  void BeginAt(const Isometry3d& X_SO) {
    stage_.Seat("head", "pendulum.head", X_SO);
    const ArmLayout& arm = *task_.layout.FindArm("right");
    const Part& head = *task_.parts.Find("head");
    ArmScene scene(task_.parts, task_.layout);
    scene.PutPart("head", stage_.PoseOf("head"));
    const auto grasps = Reach(scene, "right").Grasps("head", arm.home);
    ASSERT_TRUE(grasps) << grasps.reason();
    grasp_ = grasps->front();
    ASSERT_FALSE(head.grasps.empty());
    service_ = MakeRobotArm(stepper_, ShippedDeployment(), "right");
    Run(80);
  }

  template <class M>
  void Give(const std::string& channel, M message) {
    message.header.utime = tick_ * kTickUs;
    message.header.seq = next_seq_++;
    inputs_.push_back(*MessageFromWire(channel, Bus::Encode(message)));
  }
  void Run(int num_ticks) {
    for (int i = 0; i < num_ticks; ++i) {
      arm_state_t state{};
      ToMessage(grasp_.q_grasp, &state.num_joints, &state.position);
      ToMessage(Joints::Zero(), &state.num_joints, &state.velocity);
      state.opening = grasp_.width;
      state.stance = grasp_.grip;
      state.grip = arm_state_t::GRIPPING;
      Give("ARM_STATE_RIGHT", state);
      motion_permit_t permit{};
      permit.mode = motion_permit_t::EXECUTE;
      permit.until_utime = (tick_ + 5) * kTickUs;
      Give("MOTION_PERMIT", permit);
      if (tick_ % 12 == 0) {
        Give("TRACKS",
             TracksToMessage(stage_.AllTracked(), task_.scene_objects));
      };
      ++tick_;
      const auto inputs = std::exchange(inputs_, {});
      if (stepper_.Accept(tick_, inputs) != Stepper::State::kReady) continue;
      for (const Message& m : stepper_.Run()) {
        if (m.channel == "ARM_REPORT_RIGHT") {
          report_ = *Decode<arm_report_t>(m);
        }
        if (m.channel == "SKILL_RESULT") {
          results_.push_back(*Decode<skill_result_t>(m));
        }
      }
    }
  }
  void Ask(const std::string& skill, const SkillArguments& arguments) {
    asked_skill_t request{};
    request.id = 7;
    request.deadline_utime = (tick_ + 100) * kTickUs;
    request.arm = "right";
    request.skill = skill;
    SetArguments(arguments, &request);
    Give("SKILL_REQUEST", request);
    Run(10);
  }

  Stepper stepper_{Stepper::Params{.name = "robot_arm@right"}};
  std::unique_ptr<Service> service_;
  GraspChoice grasp_;
  std::vector<Message> inputs_;
  int32_t tick_ = 0;
  int32_t next_seq_ = 0;
  arm_report_t report_{};
  std::vector<skill_result_t> results_;
};

TEST_F(ArmThatHoldsTheHead, ReportsALooseOneAsHeldAndTakesNothingElse) {
  BeginAt(Above(0.03));
  EXPECT_EQ(report_.held, "head");
  Ask("insert", {{"part", "face_plate"}, {"site", "base.face_plate"}});
  ASSERT_EQ(results_.size(), 1u);
  EXPECT_EQ(results_[0].outcome, skill_result_t::REFUSED);
  EXPECT_EQ(results_[0].reason, "it holds head");
}

TEST_F(ArmThatHoldsTheHead, CountsASeatedOneAsPlacedAndLetsGoOfItFirst) {
  BeginAt(Above(0));
  EXPECT_EQ(report_.held, "");
  Ask("insert", {{"part", "face_plate"}, {"site", "base.face_plate"}});
  EXPECT_TRUE(results_.empty()) << results_[0].reason;
  EXPECT_EQ(report_.phase, "let go");
}

TEST_F(ArmThatHoldsTheHead, LetsGoOfOneHalfwayOnItsThreadToTurnItOn) {
  BeginAt(Above(0.004));
  Ask("insert", {{"part", "head"}, {"site", "pendulum.head"}});
  EXPECT_TRUE(results_.empty()) << results_[0].reason;
  EXPECT_EQ(report_.phase, "let go");
}

TEST_F(ArmThatHoldsTheHead, LetsGoOfOneHalfwayOnItsThreadToPutItDown) {
  BeginAt(Above(0.004));
  Ask("put_down", {{"part", "head"}});
  EXPECT_TRUE(results_.empty()) << results_[0].reason;
  EXPECT_EQ(report_.phase, "let go");
}

TEST_F(ArmThatHoldsTheHead, LetsGoOfOneHalfwayOnItsThreadToGoHome) {
  BeginAt(Above(0.004));
  Ask("go_home", {});
  EXPECT_TRUE(results_.empty()) << results_[0].reason;
  EXPECT_EQ(report_.phase, "let go");
}

TEST_F(ArmThatHoldsTheHead, StaysWhereItIsWhileNobodySeesTheHead) {
  BeginAt(Above(0.004));
  stage_.Remove("head");
  Run(20);
  Ask("go_free", {});
  ASSERT_EQ(results_.size(), 1u);
  EXPECT_EQ(results_[0].outcome, skill_result_t::REFUSED);
  EXPECT_EQ(results_[0].reason, "the pose of head is unknown");
}

}  // namespace
}  // namespace cell
