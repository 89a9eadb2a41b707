#include "services/cell/scoring/motion_check.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <memory>

#include "cell/episode_t.hpp"
#include "common/arms/arm_bodies.h"
#include "common/bus/bus.h"
#include "common/geometry/pose.h"
#include "common/kinematics/joint_values.h"
#include "common/skills/skill_arguments.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace cli;
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using Kind = Violation::Kind;

constexpr char kPart[] = "round_peg_1";

auto Is(int32_t tick, const std::string& arm, Kind kind,
        const std::string& what) {
  return AllOf(Field(&Violation::tick, tick), Field(&Violation::arm, arm),
               Field(&Violation::kind, kind),
               Field(&Violation::what, HasSubstr(what)));
}

/// A log as the cell would write it, tick by tick: both arms stand at home, the
/// parts on the table.
class MotionCheckTest : public testing::Test {
 protected:
  MotionCheckTest() {
    for (const ArmLayout& arm : task_.layout.arms) Stand(arm.name, arm.home);
    for (const Part& part : task_.parts.parts()) {
      poses_[part.name] = stage_.PoseOf(part.name);
    }
  }

  const ArmLayout& Arm(const std::string& name) const {
    return *task_.layout.FindArm(name);
  }
  void Stand(const std::string& name, const Joints& q) {
    const ArmLayout& arm = Arm(name);
    q_[name] = q;
    X_WG_[name] = GripperPose(arm, q);
    const ArmPosture posture{q, arm.hand.grips.front().name, 0.03};
    for (const auto& [body, X_WB] : NamedBodyPosesOf(arm, posture)) {
      poses_[body] = X_WB;
    }
  }
  /// Moves a part between the fingers.
  void PutInHand(const std::string& part, const std::string& arm) {
    const Grasp& grasp = task_.parts.Find(part)->grasps.front();
    poses_[part] = X_WG_.at(arm) * grasp.X_OG.inverse();
  }

  template <class M>
  void Put(const std::string& channel, M message, int32_t sender) {
    message.header.tick = tick_;
    message.header.sender = sender;
    message.header.utime = tick_ * kTickUs;
    check_.Put({channel, tick_, sender, 0, 0,
                std::make_shared<Bytes>(Bus::Encode(message))});
  }
  void PutState(const std::string& arm, double velocity = 0) {
    arm_state_t state{};
    ToMessage(velocity * Joints::Unit(2), &state.num_joints, &state.velocity);
    ToMessage(q_.at(arm), &state.num_joints, &state.position);
    Put("ARM_STATE_" + ChannelSuffix(arm), state, 0);
  }
  void PutSetpoint(const std::string& arm, int joint = 0, double by = 0) {
    arm_setpoint_t setpoint{};
    ToMessage(q_.at(arm) + by * Joints::Unit(joint), &setpoint.num_joints,
              &setpoint.position);
    Put("ARM_SETPOINT_" + ChannelSuffix(arm), setpoint, 7);
  }
  void Ask(const std::string& arm, int64_t id, const std::string& part) {
    asked_skill_t request{};
    request.id = id;
    request.arm = arm;
    SetArguments({{"part", part}}, &request);
    Put("SKILL_REQUEST", request, 5);
  }
  void Report(const std::string& arm, int64_t id, const std::string& phase,
              const std::string& held) {
    arm_report_t report{};
    report.arm = arm;
    report.request = id;
    report.phase = phase;
    static const std::map<std::string, int8_t> kContact = {
        {"close", arm_report_t::PARTS_AND_TABLE},
        {"lift", arm_report_t::PARTS_AND_TABLE},
        {"set down", arm_report_t::PARTS_AND_TABLE},
        {"let go", arm_report_t::PARTS_AND_TABLE},
        {"draw back", arm_report_t::PARTS_AND_TABLE},
        {"seat", arm_report_t::PARTS},
        {"turn", arm_report_t::PARTS}};
    const auto contact = kContact.find(phase);
    if (contact != kContact.end()) report.contact = contact->second;
    report.held = held;
    Put("ARM_REPORT_" + ChannelSuffix(arm), report, 7);
  }
  // Of the held part, in a skill that could touch it before.
  void ExpectCollisionInCarrying(const std::string& other) {
    Report("right", 3, "carry", kPart);
    Look();
    EXPECT_THAT(
        check_.violations(),
        ElementsAre(Is(3, "right", Kind::kCollision,
                       "round_peg_1 touches " + other + ", skill 3: carry")));
  }

  void Look() {
    ++tick_;
    truth_poses_t truth{};
    for (const auto& [name, X_WB] : poses_) {
      truth.bodies.push_back({name, PoseToMessage(X_WB)});
    }
    truth.num_bodies = static_cast<int32_t>(truth.bodies.size());
    Put("TRUTH_POSES", truth, 0);
  }

  ShippedTask task_;
  Stage stage_{task_};
  MotionCheck check_{task_.layout, task_.parts};
  std::map<std::string, Isometry3d> poses_, X_WG_;
  std::map<std::string, Joints> q_;
  int32_t tick_ = 0;
};

TEST_F(MotionCheckTest, NothingIsWrongWithArmsAtHome) {
  for (int i = 0; i < 5; ++i) {
    Look();
    for (const char* arm : {"left", "right"}) {
      PutState(arm);
      PutSetpoint(arm);
      Report(arm, -1, "", "");
    }
  }
  EXPECT_THAT(check_.violations(), IsEmpty());
  EXPECT_EQ(check_.num_protective_stops(), 0);
}

TEST_F(MotionCheckTest, ALinkInThePedestalIsFoundOnce) {
  Look();
  EXPECT_THAT(check_.violations(), IsEmpty());
  poses_["arm_right.link_5"] =
      Translation3d(0, 0, 0.10) * Isometry3d::Identity();
  poses_["base"] = Isometry3d(Translation3d(0, 0, 2));
  Look();
  Look();
  EXPECT_THAT(check_.violations(),
              ElementsAre(Is(2, "right", Kind::kCollision,
                             "arm_right.link_5 touches pedestal")));
}

TEST_F(MotionCheckTest, ALinkThatReachesIntoTheTableIsFound) {
  poses_["arm_left.link_6"] = Isometry3d(Translation3d(-0.5, 0.3, 0.03));
  Look();
  EXPECT_THAT(check_.violations(),
              ElementsAre(Is(1, "left", Kind::kCollision,
                             "arm_left.link_6 touches table")));
}

TEST_F(MotionCheckTest, ArmsThatMeetAreFoundOnce) {
  poses_["arm_left.link_6"] = poses_.at("arm_right.link_6");
  poses_["arm_left.link_6"].translation().z() += 0.02;
  Look();
  const auto pairs = std::ranges::count_if(
      check_.violations(), [](const Violation& violation) {
        return violation.what.find(
                   "arm_left.link_6 touches arm_right.link_6") !=
               std::string::npos;
      });
  EXPECT_EQ(pairs, 1);
}

TEST_F(MotionCheckTest, AFingerInAPartThatIsNotBeingGraspedIsFound) {
  Ask("right", 3, "round_peg_2");
  Report("right", 3, "reach", "");
  const std::string box = Arm("right").gripper + ".finger_1";
  poses_[kPart] = poses_.at(box);
  Look();
  ASSERT_FALSE(check_.violations().empty());
  const auto found = std::ranges::find_if(
      check_.violations(), [&](const Violation& violation) {
        return violation.what == box + " touches " + kPart + ", skill 3: reach";
      });
  ASSERT_NE(found, check_.violations().end());
  EXPECT_EQ(found->tick, 1);
  EXPECT_EQ(found->arm, "right");
}

TEST_F(MotionCheckTest, TheHandMayTouchWhatItGraspsUntilItHasDrawnBack) {
  PutInHand(kPart, "right");
  Ask("right", 3, kPart);
  for (const auto& [phase, held] : {std::pair{"close", ""},
                                    {"lift", kPart},
                                    {"carry", kPart},
                                    {"seat", kPart},
                                    {"let go", kPart},
                                    {"draw back", ""}}) {
    Report("right", 3, phase, held);
    Look();
  }
  EXPECT_THAT(check_.violations(), IsEmpty());
  Report("right", -1, "", "");
  Look();
  EXPECT_THAT(check_.violations(),
              testing::Contains(Is(7, "right", Kind::kCollision,
                                   std::string("touches ") + kPart)));
}

TEST_F(MotionCheckTest, AHeldPartMayTouchOthersWhereItIsSeatedNotOnTheWay) {
  PutInHand(kPart, "right");
  poses_["head"] = poses_.at(kPart);
  poses_["head"].translation().z() -= 0.055;
  Ask("right", 3, kPart);
  Report("right", 3, "lift", kPart);
  Look();
  Report("right", 3, "seat", kPart);
  Look();
  EXPECT_THAT(check_.violations(), IsEmpty());
  ExpectCollisionInCarrying("head");
}

TEST_F(MotionCheckTest, AHeldPartMayTouchTheTableWhereItIsTakenNotOnTheWay) {
  Ask("right", 3, kPart);
  for (const char* phase : {"lift", "set down"}) {
    Report("right", 3, phase, kPart);
    Look();
  }
  EXPECT_THAT(check_.violations(), IsEmpty());
  ExpectCollisionInCarrying("table");
}

TEST_F(MotionCheckTest, AStandingArmIsNotBlamedForWhatAPersonMovesAgainstIt) {
  poses_[kPart] = poses_.at("arm_right.link_6");
  const CellLayout::Hand& hand = task_.layout.hands.front();
  for (const HandType::Box& box : hand.type.boxes) {
    poses_[hand.name + "." + box.name] = poses_.at(kPart);
  }
  PutState("right");
  Look();
  EXPECT_THAT(check_.violations(), IsEmpty());
  PutState("right", 0.5);
  Look();
  EXPECT_THAT(check_.violations(),
              testing::Contains(Is(2, "right", Kind::kCollision,
                                   std::string("link_6 touches ") + kPart)));
}

TEST_F(MotionCheckTest, AJointThatIsTooFastIsFound) {
  tick_ = 12;
  PutState("left", -3.1);
  PutState("right", -3.3);
  PutState("right", -3.3);
  EXPECT_THAT(check_.violations(),
              ElementsAre(Is(12, "right", Kind::kSpeed,
                             "joint 3 turns at 3.30 rad/s")));
}

TEST_F(MotionCheckTest, AJointBeyondItsRangeIsFound) {
  tick_ = 4;
  q_["left"][5] = 6.3;
  PutState("left");
  EXPECT_THAT(check_.violations(), ElementsAre(Is(4, "left", Kind::kPosition,
                                                  "joint 6 is at 6.300 rad")));
}

TEST_F(MotionCheckTest, ASetpointThatJumpsIsFound) {
  constexpr double kStep = 0.025;  // [rad] in a tick of 8 ms: 3.125 rad/s
  for (const double by : {0.0, kStep, 2 * kStep, 2 * kStep + 0.03}) {
    ++tick_;
    PutSetpoint("right", 4, by);
  }
  EXPECT_THAT(check_.violations(),
              ElementsAre(Is(4, "right", Kind::kSetpoint,
                             "joint 5 jumps by 0.0300 rad in 8 ms")));
}

TEST_F(MotionCheckTest, WhereAnEpisodeBeginsSetpointsMayJump) {
  PutSetpoint("right", 4, 0);
  ++tick_;
  episode_t episode{};
  episode.phase = episode_t::START;
  Put("EPISODE", episode, 0);
  PutSetpoint("right", 4, 1);
  EXPECT_THAT(check_.violations(), IsEmpty());
}

TEST_F(MotionCheckTest, AGripperThatMovesOutsideIsFound) {
  q_["right"][0] += 2.6;  // away from the table
  PutState("right");
  EXPECT_THAT(check_.violations(), IsEmpty());
  PutState("right", 0.5);
  EXPECT_THAT(check_.violations(),
              ElementsAre(Is(0, "right", Kind::kWorkspace,
                             "the gripper moves outside")));
}

TEST_F(MotionCheckTest, ProtectiveStopsAreCounted) {
  for (const int8_t servo :
       {arm_state_t::FOLLOWING, arm_state_t::STOPPED, arm_state_t::STOPPED,
        arm_state_t::FOLLOWING, arm_state_t::STOPPED}) {
    arm_state_t state{};
    ToMessage(Joints::Zero(), &state.num_joints, &state.velocity);
    ToMessage(q_.at("right"), &state.num_joints, &state.position);
    state.servo = servo;
    Put("ARM_STATE_RIGHT", state, 0);
  }
  EXPECT_EQ(check_.num_protective_stops(), 2);
}

TEST_F(MotionCheckTest, AnotherNumberOfJointsIsABreach) {
  arm_state_t state{};
  state.num_joints = 7;
  state.position = state.velocity = std::vector<double>(7, 0.0);
  Put("ARM_STATE_RIGHT", state, 0);
  ASSERT_EQ(check_.violations().size(), 1u);
  EXPECT_THAT(check_.violations().front().what,
              testing::HasSubstr("has 7 joints instead of the 6 of a ur5"));
}

TEST_F(MotionCheckTest, WhatDoesNotDecodeIsPassedOver) {
  check_.Put({"TRUTH_POSES", 1, 0, 0, 0, std::make_shared<Bytes>(Bytes{1, 2})});
  EXPECT_THAT(check_.violations(), IsEmpty());
}

TEST_F(MotionCheckTest, ReportsMessagesThatItCouldNotCheck) {
  EXPECT_THAT(check_.Gaps(),
              ElementsAre("ARM_STATE_LEFT: the log holds no message",
                          "ARM_STATE_RIGHT: the log holds no message",
                          "TRUTH_POSES: the log holds no message"));
  PutState("left");
  check_.Put({"ARM_STATE_LEFT", 1, 0, 0, 0,
              std::make_shared<Bytes>(Bytes(40, uint8_t{7}))});
  EXPECT_THAT(check_.Gaps()[0],
              "ARM_STATE_LEFT: 1 of 2 messages are damaged or of another type "
              "than this program's");
}

}  // namespace
}  // namespace cell
