// Parts on hinges and slides, in the physics and in a person's hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>

#include "cell/tracks_t.hpp"
#include "cell/truth_poses_t.hpp"
#include "common/bus/sim_bus.h"
#include "common/geometry/pose.h"
#include "services/tracker/tracker.h"
#include "services/vtb/hand_actions.h"
#include "services/vtb/hand_actor.h"
#include "services/vtb/mujoco_pose.h"
#include "services/vtb/vtb.h"
#include "services/vtb/world.h"
#include "tests/sim/cabinet.h"
#include "tests/test_folder.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace vtb;
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using testing::IsEmpty;

constexpr double kTick = 0.008;
constexpr char kHand[] = "hand_right", kOtherHand[] = "hand_left";
constexpr double kLever = 0.28;  // [m] of the leaf's handle, about

PartTable CabinetTable() {
  return PartTable::FromConfig(Config::Parse(
      "contacts:\n" + std::string(kCabinetContacts) + "parts:" + kCabinetParts,
      "parts.yaml"));
}

HumanMotionParams Steady() {
  HumanMotionParams human_motion;
  human_motion.close_time = 0.2;
  human_motion.open_margin = 0.014;
  human_motion.insert_speed = 0.1;
  human_motion.dwell = 0.1;
  human_motion.clearance = 0.04;
  human_motion.speed_spread = 0.2;
  return human_motion;
}

class Articulated : public testing::Test {
 protected:
  void Do(const HandAction& action) { hand_.Do(action); }
  void TakeHandle(const std::string& part) {
    Do(hand_action::Reach(part));
    Do(hand_action::Grasp(part));
  }
  void LetGo(const std::string& part) {
    Do(hand_action::Release(part));
    Do(hand_action::Retreat());
    Do(hand_action::Rest());
  }
  void Step() {
    hand_.Update(kTick, world_, sampler_, random_);
    world_.Run(4);
    for (const auto& part : {"leaf", "tray"}) {
      auto& [low, high] = range_[part];
      low = std::min(low, world_.JointOf(part));
      high = std::max(high, world_.JointOf(part));
    }
    for (const BodyContact& contact : world_.Contacts()) {
      double& force = contacts_[{contact.first, contact.second}];
      force = std::max(force, contact.normal_force);
    }
  }
  void Finish() {
    for (int tick = 0; tick < 7500 && !hand_.is_idle(); ++tick) Step();
    ASSERT_TRUE(hand_.is_idle());
  }
  const PartJoint& Joint(const std::string& part) const {
    return *world_.table().Find(part)->joint;
  }
  Isometry3d Handle(const std::string& part) const {
    return world_.PoseOf(part) * world_.table().Find(part)->grasps[0].X_OG;
  }
  /// Puts a hand, or a gripper, at the handle and closes it.
  void GripAtOnce(const std::string& hand, const std::string& part) {
    world_.hands().Place(hand, Handle(part), 0.012);
    world_.hands().Grip(hand, part);
  }

  World world_{CabinetTable(), ShippedTask().layout, {.dt = 0.002}};
  PlacementSampler sampler_{world_.table(), world_.layout(), 0.04};
  HandActor hand_{kHand, Steady(), world_};
  std::mt19937_64 random_{5};
  std::map<std::string, std::pair<double, double>> range_;
  std::map<std::pair<std::string, std::string>, double> contacts_;
};

TEST_F(Articulated, TheHandOpensAHingeToItsLimitAndClosesItAgain) {
  TakeHandle("leaf");
  Do(hand_action::Open("leaf"));
  LetGo("leaf");
  Finish();
  EXPECT_NEAR(world_.JointOf("leaf"), Joint("leaf").upper, 0.002 / kLever);
  EXPECT_FALSE(world_.hands().HeldBy(kHand));
  TakeHandle("leaf");
  Do(hand_action::Close("leaf"));
  LetGo("leaf");
  Finish();
  EXPECT_NEAR(world_.JointOf("leaf"), Joint("leaf").lower, 0.002 / kLever);
  EXPECT_THAT(hand_.failures(), IsEmpty());
  EXPECT_GT(range_["leaf"].first, Joint("leaf").lower - 0.005);
  EXPECT_LT(range_["leaf"].second, Joint("leaf").upper + 0.005);
  EXPECT_NEAR(range_["tray"].second, 0, 1e-3) << "the other one stays";
}

TEST_F(Articulated, TheHandPullsASlideToItsLimitAndPushesItIn) {
  TakeHandle("tray");
  Do(hand_action::Pull("tray"));
  LetGo("tray");
  Finish();
  EXPECT_NEAR(world_.JointOf("tray"), Joint("tray").upper, 0.002);
  TakeHandle("tray");
  Do(hand_action::Push("tray"));
  LetGo("tray");
  Finish();
  EXPECT_NEAR(world_.JointOf("tray"), Joint("tray").lower, 0.002);
  EXPECT_THAT(hand_.failures(), IsEmpty());
  EXPECT_GT(range_["tray"].first, Joint("tray").lower - 0.001);
  EXPECT_LT(range_["tray"].second, Joint("tray").upper + 0.001);
}

TEST_F(Articulated, WhatTouchesIsReported) {
  world_.SetJoint("leaf", 0.5);
  TakeHandle("leaf");
  Do(hand_action::Close("leaf"));
  LetGo("leaf");
  Finish();
  EXPECT_TRUE(contacts_.contains({"hand_right.thumb", "leaf"}));
  EXPECT_GT((contacts_[{"cabinet", "leaf"}]), 0) << "shut with a push";
}

TEST_F(Articulated, WhatJamsBeforeItsLimitIsAFailure) {
  const int joint =
      world_.model()
          .body_jntadr[mj_name2id(&world_.model(), mjOBJ_BODY, "tray")];
  world_.model().jnt_range[2 * joint + 1] = 0.14;  // [m] 10 mm before it
  TakeHandle("tray");
  Do(hand_action::Pull("tray"));
  LetGo("tray");
  Finish();
  EXPECT_THAT(hand_.failures(), testing::ElementsAre("tray"));
  EXPECT_FALSE(world_.hands().HeldBy(kHand));
}

TEST_F(Articulated, ItStaysWhereItIsLeft) {
  world_.SetJoint("leaf", 0.7);
  world_.SetJoint("tray", 0.08);
  world_.Run(1000);
  EXPECT_NEAR(world_.JointOf("leaf"), 0.7, 1e-3);
  EXPECT_NEAR(world_.JointOf("tray"), 0.08, 1e-4);
}

TEST_F(Articulated, ItSleepsWhereItIsLeftUntilItIsMoved) {
  world_.SetJoint("leaf", 0.7);
  world_.SetJoint("tray", 0.08);
  world_.Run(1000);
  EXPECT_TRUE(world_.IsAsleep("leaf"));
  EXPECT_TRUE(world_.IsAsleep("tray"));
  const double before = world_.JointOf("tray");
  world_.SetJoint("leaf", 0.5);
  world_.Run(400);
  EXPECT_EQ(world_.JointOf("tray"), before);
  GripAtOnce(kHand, "tray");
  Isometry3d X_WG = Handle("tray");
  X_WG.translation() +=
      0.02 * (world_.PoseOf("tray").linear() * Joint("tray").axis);
  world_.hands().Move(kHand, X_WG, 0.012);
  world_.Run(200);
  EXPECT_FALSE(world_.IsAsleep("tray"));
  EXPECT_NEAR(world_.JointOf("tray"), before + 0.02, 2e-3);
}

TEST_F(Articulated, ItsPoseIsThatOfItsBody) {
  for (const double position : {-0.1, 0.0, 0.4, 1.3}) {
    world_.SetJoint("leaf", position);
    world_.SetJoint("tray", position / 10);
    mj_kinematics(&world_.model(), &world_.data());
    for (const char* part : {"leaf", "tray"}) {
      const int body = mj_name2id(&world_.model(), mjOBJ_BODY, part);
      const Isometry3d X_WO = PoseFromMujoco(world_.data().xpos + 3 * body,
                                             world_.data().xquat + 4 * body);
      EXPECT_TRUE(world_.PoseOf(part).isApprox(X_WO, 1e-9)) << part;
    }
  }
}

TEST_F(Articulated, ACopyOfTheHandGoesOnInTheSameWay) {
  TakeHandle("leaf");
  Do(hand_action::Open("leaf"));
  while (world_.JointOf("leaf") < 0.6) Step();
  const World::Snapshot snapshot = world_.Save();
  const HandActor copy = hand_;
  const std::mt19937_64 random = random_;
  for (int tick = 0; tick < 200; ++tick) Step();
  const Isometry3d first = world_.PoseOf("leaf");
  world_.Restore(snapshot);
  hand_ = copy;
  random_ = random;
  for (int tick = 0; tick < 200; ++tick) Step();
  EXPECT_EQ(world_.PoseOf("leaf").matrix(), first.matrix());
}

TEST_F(Articulated, AHandGivesUpWhatAnotherOneHolds) {
  Do(hand_action::Reach("tray"));
  Finish();
  GripAtOnce(kOtherHand, "tray");
  Do(hand_action::Grasp("tray"));
  Do(hand_action::Pull("tray"));
  Finish();
  EXPECT_EQ(world_.hands().HeldBy(kOtherHand), "tray");
  EXPECT_FALSE(world_.hands().HeldBy(kHand));
  EXPECT_LT((world_.hands().StateOf(kHand).X_WG.translation() -
             world_.layout().hands.back().p_WG_rest)
                .norm(),
            1e-6);
}

TEST_F(Articulated, WhatSlidesIsNotOpenedAndWhatIsArticulatedNotPlaced) {
  TakeHandle("tray");
  Do(hand_action::Open("tray"));
  EXPECT_THROW(Finish(), std::invalid_argument);
  EXPECT_THROW(world_.Place("leaf", Isometry3d::Identity()),
               std::invalid_argument);
  EXPECT_THROW(world_.SetJoint("cabinet", 0), std::invalid_argument);
}

TEST_F(Articulated, ItIsNotScatteredOnTheTable) {
  std::mt19937_64 random(1);
  EXPECT_THAT(sampler_.Scatter(random), IsEmpty());
}

/// Moves a gripper with a part's handle at `rate` of the joint [1/s], and tells
/// the mean wrench on it once that is steady.
Wrench WrenchWhileMoving(World& world, const std::string& gripper,
                         const std::string& part, double rate) {
  const PartJoint& joint = *world.table().Find(part)->joint;
  const Isometry3d X_WO = world.PoseOf(part);
  const Isometry3d X_OG = world.table().Find(part)->grasps[0].X_OG;
  Wrench mean;
  constexpr int kTicks = 150, kSteady = 100;
  for (int tick = 1; tick <= kTicks; ++tick) {
    world.hands().Move(
        gripper, X_WO * joint.Displacement(rate * kTick * tick) * X_OG, 0.012);
    world.Run(4);
    if (tick <= kSteady) continue;
    const Wrench now = world.hands().WrenchOn(gripper);
    mean.force += now.force / (kTicks - kSteady);
    mean.torque += now.torque / (kTicks - kSteady);
  }
  return mean;
}

TEST_F(Articulated, AGripperFeelsTheFrictionOfASlide) {
  const std::string gripper = world_.layout().arms.front().gripper;
  GripAtOnce(gripper, "tray");
  constexpr double kRate = 0.05;  // [m/s]
  const Wrench wrench = WrenchWhileMoving(world_, gripper, "tray", kRate);
  const double expected =
      Joint("tray").friction + kRate * Joint("tray").damping;
  // It pulls along z of G.
  EXPECT_NEAR(wrench.force.z(), -expected, 0.1 * expected);
}

TEST_F(Articulated, AGripperFeelsTheFrictionOfAHinge) {
  const std::string gripper = world_.layout().arms.front().gripper;
  world_.SetJoint("leaf", 0.2);
  GripAtOnce(gripper, "leaf");
  constexpr double kRate = 0.3;  // [rad/s]
  const PartJoint& joint = Joint("leaf");
  const Isometry3d X_GO = Handle("leaf").inverse() * world_.PoseOf("leaf");
  const Wrench wrench = WrenchWhileMoving(world_, gripper, "leaf", kRate);
  // About the hinge, in G.
  const Vector3d moment =
      wrench.torque - (X_GO * joint.p_OA).cross(wrench.force);
  const double expected = joint.friction + kRate * joint.damping;
  EXPECT_NEAR(moment.dot(X_GO.linear() * joint.axis), -expected,
              0.1 * expected);
}

TEST_F(Articulated, AHandThatGoesOnDoesNotBreakALimit) {
  GripAtOnce(kHand, "tray");
  Isometry3d X_WG = Handle("tray");
  const Vector3d out = world_.PoseOf("tray").linear() * Joint("tray").axis;
  for (int tick = 0; tick < 125; ++tick) {
    X_WG.translation() += 0.00128 * out;  // 160 mm
    world_.hands().Move(kHand, X_WG, 0.012);
    world_.Run(4);
    EXPECT_LT(world_.JointOf("tray"), Joint("tray").upper + 0.002) << tick;
  }
  EXPECT_NEAR(world_.JointOf("tray"), Joint("tray").upper, 0.002);
}

/// The shipped task with the cabinet in it besides.
Deployment WithCabinet() {
  Deployment deployment = ShippedDeployment();
  const auto dir = NewTestFolder();
  std::filesystem::copy(deployment.task_dir, dir);
  const auto insert = [&](const char* file, const std::string& after,
                          const std::string& added, const std::string& end) {
    std::stringstream stream;
    stream << std::ifstream(dir / file).rdbuf();
    std::string text = stream.str();
    text.insert(text.find(after) + after.size(), added);
    std::ofstream(dir / file) << text << end;
  };
  insert("parts.yaml", "contacts:\n", kCabinetContacts, kCabinetParts);
  insert("domain.yaml", "types:\n", kCabinetTypes, "");
  deployment.task_dir = dir;
  return deployment;
}

TEST(ArticulatedTask, TruthAndTracksCarryWhatMovesLikeAnyPart) {
  const Deployment deployment = WithCabinet();
  Roster roster;
  roster.task = "with_cabinet";
  roster.entries = {{"vtb"}, {"tracker", 1, "tracker_ideal"}};
  std::map<std::string, ServiceFactory> factories;
  factories["vtb"] = [&](Bus& b) {
    return MakeVtb(b, deployment, "two_pegs", 1);
  };
  factories["tracker"] = [&](Bus& b) {
    return MakeTracker(b, deployment);
  };
  SimBus bus(roster, std::move(factories));
  std::set<std::string> in_truth, in_tracks;
  for (int tick = 0; tick < 100 && bus.Step(); ++tick) {
    for (const Message& message : bus.last_messages()) {
      const auto* bytes = message.bytes->data();
      const int size = static_cast<int>(message.bytes->size());
      if (truth_poses_t poses{}; message.channel == "TRUTH_POSES") {
        poses.decode(bytes, 0, size);
        for (const auto& body : poses.bodies) in_truth.insert(body.name);
      }
      if (tracks_t tracks{}; message.channel == "TRACKS") {
        tracks.decode(bytes, 0, size);
        for (const auto& track : tracks.tracks) in_tracks.insert(track.name);
      }
    }
  }
  EXPECT_THAT(in_truth, testing::IsSupersetOf({"leaf", "tray", "cabinet"}));
  EXPECT_THAT(in_tracks, testing::IsSupersetOf({"leaf", "tray"}));
}

}  // namespace
}  // namespace cell
