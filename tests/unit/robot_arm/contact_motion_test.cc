// Whole motions in contact: with a peg, a hole and a thread made of springs,
// and on an arm.
#include "services/robot_arm/contact/contact_motion.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "services/robot_arm/contact/contact_stage.h"
#include "services/robot_arm/contact/insertion.h"
#include "services/robot_arm/contact/screwing.h"
#include "tests/unit/robot_arm/control_period.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace robot_arm;
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::HasSubstr;
using State = ContactMotion::State;

constexpr double kStiffness = 10'000;  // [N/m] of arm and grip
constexpr double kPlay = 0.001;        // [m] of a hole
constexpr double kRim = 0.02;          // [m] height of a hole's rim
constexpr double kPitch = 0.008;       // [m]

/// A hole off the axis: the part stands on its rim until it is over it.
struct Hole {
  Vector2d centre = Vector2d::Zero();
  bool is_in = false;

  double FloorUnder(const Isometry3d& X_SO) const {
    const double beside = (X_SO.translation().head<2>() - centre).norm();
    return is_in || beside < kPlay ? 0 : kRim;
  }
  /// What the part feels, and its height.
  ContactWrench Press(const Isometry3d& X_SO, double* height) {
    const double floor = FloorUnder(X_SO);
    const double z = X_SO.translation().z();
    *height = std::max(z, floor);
    is_in |= *height < kRim - kPlay;
    return {{0, 0, kStiffness * std::max(0.0, floor - z)}};
  }
};

struct Course {
  State state = State::kRunning;
  double seconds = 0;
  double longest_step = 0;  // [m] of the command in a tick
};

Course Insert(ContactMotion& motion, Hole hole) {
  Course course;
  Vector3d last = motion.PartPose().translation();
  while (course.state == State::kRunning) {
    double height = 0;
    const ContactWrench contact = hole.Press(motion.PartPose(), &height);
    course.state = motion.Step(contact, height, kDt);
    course.seconds += kDt;
    const Vector3d p = motion.PartPose().translation();
    course.longest_step = std::max(course.longest_step, (p - last).norm());
    last = p;
  }
  return course;
}

TEST(InsertionMotion, BringsThePartToItsSeatAndPushesNoHarderThanAsked) {
  const InsertionParams params;
  ContactMotion motion = MakeInsertion(params, 0.1);
  const Course course = Insert(motion, {});
  EXPECT_EQ(course.state, State::kDone) << motion.reason();
  EXPECT_NEAR(motion.PartPose().translation().z(), 0, 0.002);
  EXPECT_GT(motion.peak_force(), 0.6 * params.feed.push);
  EXPECT_LT(motion.peak_force(), 1.05 * params.feed.push);
  EXPECT_LE(course.longest_step, params.feed.free_feed * kDt + 1e-12);
  EXPECT_LT(course.seconds, 8);
}

TEST(InsertionMotion, FindsAHoleThatIsElsewhere) {
  ContactMotion motion = MakeInsertion({}, 0.03);
  const Hole hole{{0.0025, -0.001}};
  EXPECT_EQ(Insert(motion, hole).state, State::kDone) << motion.reason();
  EXPECT_LT((motion.PartPose().translation().head<2>() - hole.centre).norm(),
            kPlay);
}

TEST(InsertionMotion, IsStuckWithoutASearch) {
  InsertionParams params;
  params.contact.search.max_spirals = 0;
  ContactMotion motion = MakeInsertion(params, 0.03);
  EXPECT_EQ(Insert(motion, {{0.0025, 0}}).state, State::kFailed);
  EXPECT_THAT(motion.reason(), HasSubstr("stuck 20.0 mm from its seat"));
}

TEST(InsertionMotion, SaysThatNoSearchHasFoundTheWayIn) {
  InsertionParams params;
  params.contact.search = {.radius = 0.002, .max_spirals = 2};
  ContactMotion motion = MakeInsertion(params, 0.03);
  EXPECT_EQ(Insert(motion, {{0.01, 0}}).state, State::kFailed);
  EXPECT_EQ(motion.reason(),
            "2 searches, the maximum allowed (search.max_spirals), found no "
            "way in, 20.0 mm from the seat");
}

TEST(InsertionMotion, EndsAtTheLimitsOfForceAndTime) {
  InsertionParams params;
  params.contact.limits = {.force = 40, .time = 2};
  ContactMotion pushed = MakeInsertion(params, 0.1);
  EXPECT_EQ(pushed.Step({{30, 0, 30}}, 0.1, kDt), State::kFailed);
  EXPECT_THAT(pushed.reason(), HasSubstr("limits.force_n"));
  EXPECT_GT(pushed.peak_force(), 42);
  ContactMotion slow = MakeInsertion(params, 0.2);
  EXPECT_NEAR(Insert(slow, {}).seconds, 2, 2 * kDt);
  EXPECT_THAT(slow.reason(), HasSubstr("limits.time_s"));
}

TEST(InsertionMotion, GivesWaySidewaysAndSlowsDown) {
  ContactMotion free = MakeInsertion({}, 0.2), pushed = MakeInsertion({}, 0.2);
  for (int i = 0; i < 50; ++i) {
    free.Step({}, 0.2, kDt);
    pushed.Step({{0, 10, 0}, {0, 0, 0.1}}, 0.2, kDt);
  }
  EXPECT_NEAR(pushed.PartPose().translation().y(), 2e-5 * 10 + 4e-4 * 10 * 0.4,
              1e-9);
  EXPECT_GT(AngleAxisd(pushed.PartPose().linear()).angle(), 0.001);
  const double slowed = 0.2 - pushed.PartPose().translation().z();
  const double full = 0.2 - free.PartPose().translation().z();
  EXPECT_NEAR(slowed / full, 1 / (1 + 0.3 * 7), 1e-9);
}

/// A thread that is tight at the height 0.
ContactWrench OnThread(const ContactMotion& motion) {
  const double z = motion.PartPose().translation().z();
  return {{0, 0, kStiffness * std::max(0.0, -z)},
          {0, 0, 1000 * std::max(0.0, -z)}};
}

TEST(ScrewingMotion, FollowsTheThreadUntilItIsTight) {
  const ScrewingParams params;
  const Isometry3d X_SO =
      Translation3d(0, 0.0005, 0.01) * AngleAxisd(0.4, Vector3d::UnitZ());
  ContactMotion motion = MakeScrewing(params, kPitch, X_SO);
  EXPECT_TRUE(motion.PartPose().isApprox(X_SO, 1e-12));
  State state = State::kRunning;
  double seconds = 0;
  while (state == State::kRunning) {
    state = motion.Step(OnThread(motion), 0.001, kDt);
    seconds += kDt;
    ASSERT_LT(seconds, 10);
  }
  EXPECT_EQ(state, State::kDone) << motion.reason();
  EXPECT_NEAR(motion.PartPose().translation().x(), 0, 1e-12);
  EXPECT_NEAR(motion.PartPose().translation().y(), 0.0005, 1e-12);
  EXPECT_LT(motion.PartPose().translation().z(), 0);
  EXPECT_GT(seconds * params.thread.rate, params.tight.min_angle);
  EXPECT_GT(motion.peak_force(), 1);
}

TEST(ScrewingMotion, JamsWhereItIsTightTooEarly) {
  ContactMotion motion = MakeScrewing({}, kPitch, Isometry3d::Identity());
  EXPECT_EQ(motion.Step({.torque = {0, 0, 1}}, 0.004, kDt), State::kFailed);
  EXPECT_THAT(motion.reason(), HasSubstr("jammed 4.0 mm from its seat"));
}

TEST(ScrewingMotion, LimitsItsForceAndItsDrift) {
  const ScrewingParams params;
  ContactMotion motion =
      MakeScrewing(params, kPitch, Isometry3d(Translation3d(0, 0, 0.01)));
  for (int i = 0; i < 500; ++i) {
    ASSERT_EQ(motion.Step({{20, 0, 0}}, 0.01, kDt), State::kRunning)
        << motion.reason();
  }
  EXPECT_NEAR(motion.PartPose().translation().x(),
              params.contact.admittance.max_drift + 2e-5 * 20, 1e-9);
  EXPECT_EQ(motion.peak_force(), 20);
  EXPECT_EQ(motion.Step({{101, 0, 0}}, 0.01, kDt), State::kFailed);
  EXPECT_THAT(motion.reason(), HasSubstr("limits.force_n"));
}

TEST(ScrewingMotion, NeedsLessTurningOfAPartThatIsOnItsThread) {
  const ScrewingParams params;
  const auto min_angle = [&](double height) {
    return params.GoingOnAt(height, kPitch).tight.min_angle;
  };
  EXPECT_NEAR(min_angle(0.004), std::numbers::pi - params.early_angle, 1e-9);
  EXPECT_EQ(min_angle(0), 0);
  EXPECT_EQ(min_angle(0.1), params.tight.min_angle);
}

/// Sideways at 10 mm/s, slowed down with the rest, pressing with 5 N.
class Sideways : public MotionReference {
 public:
  Step Advance(const ContactState&, double rate, double dt) override {
    return {.translation = {0.01 * rate * dt, 0, 0}, .is_pressing = true};
  }
  double push() const override { return 5; }
};

class Never : public Termination {
 public:
  Verdict Judge(const ContactState&) const override { return {}; }
  double DistanceLeft(double height) const override { return height; }
};

TEST(ContactMotion, AddsForceControlToAnyReferenceAsEquation2) {
  ContactMotion motion({}, std::make_unique<Sideways>(),
                       std::make_unique<Never>(), Isometry3d::Identity());
  for (int i = 0; i < 125; ++i) motion.Step({{0, 0, 2}}, 0, kDt);
  const Vector3d p(0.01, 0, -4e-4 * 3);
  EXPECT_TRUE(motion.PartPose().translation().isApprox(p, 1e-9));
}

/// The right arm over a site straight below its gripper.
class ContactOnArm : public testing::Test {
 protected:
  ContactOnArm() {
    reading_.q = arm_.home;
    command_.q = arm_.home;
    frames_.X_WS = kinematics_.GripperPose(arm_.home);
    frames_.X_WS.linear().setIdentity();
    frames_.X_WS.translation().z() -= 0.1;
    frames_.X_GO.linear() =
        kinematics_.GripperPose(arm_.home).linear().transpose();
    Sense(Vector3d::Zero());
  }

  /// The sensor reads `force_W` on the part beside all weights.
  void Sense(const Vector3d& force_W) {
    const Isometry3d X_WS = kinematics_.SensorPose(reading_.q);
    const Isometry3d X_WF =
        kinematics_.GripperPose(reading_.q) * arm_.X_FG.inverse();
    const Vector3d p_S = X_WS.inverse() * (X_WF * arm_.p_F_tool);
    const Vector3d weight =
        X_WS.linear().transpose() * Vector3d(0, 0, -9.81 * arm_.tool_mass);
    const Vector3d force = X_WS.linear().transpose() * force_W;
    const Vector3d part_S =
        X_WS.inverse() * kinematics_.GripperPose(reading_.q).translation();
    reading_.wrench = ArmReading::SensedWrench{
        weight + force, p_S.cross(weight) + part_S.cross(force)};
  }
  SkillStage::State Step(ContactStage& stage) {
    sensor_.Update(reading_, kDt);
    return stage.Step(reading_, kDt, &command_);
  }

  void ExpectForceLimit(const ContactMotionMaker& maker) {
    ContactStage stage(kinematics_, sensor_, frames_, maker, &peak_force_);
    Sense({0, 60, 0});
    for (int i = 0; i < 20; ++i) {
      EXPECT_EQ(Step(stage), SkillStage::State::kRunning)
          << stage.failure().reason;
    }
    EXPECT_NEAR(peak_force_, 60, 0.1);
    Sense({0, 150, 0});
    SkillStage::State state = SkillStage::State::kRunning;
    for (int i = 0; i < 20 && state == SkillStage::State::kRunning; ++i) {
      state = Step(stage);
    }
    EXPECT_EQ(state, SkillStage::State::kFailed);
    EXPECT_THAT(stage.failure().reason, HasSubstr("limits.force_n"));
    EXPECT_GT(peak_force_, 100);
  }

  CellLayout layout_ =
      CellLayout::FromConfig(ShippedDeployment().OfTask("cell.yaml"));
  const ArmLayout& arm_ = *layout_.FindArm("right");
  ToolKinematics kinematics_{arm_};
  ContactSensor sensor_{kinematics_, arm_, {}};
  ArmReading reading_;
  ArmCommand command_;
  SiteFrames frames_;
  double peak_force_ = 0;
};

TEST_F(ContactOnArm, FollowsTheMotionWithItsJoints) {
  ContactStage stage(kinematics_, sensor_, frames_, InsertionMaker({}),
                     &peak_force_);
  const Vector3d begin = kinematics_.GripperPose(command_.q).translation();
  for (int i = 0; i < 25; ++i) {
    ASSERT_EQ(Step(stage), SkillStage::State::kRunning)
        << stage.failure().reason;
  }
  const Vector3d way =
      kinematics_.GripperPose(command_.q).translation() - begin;
  EXPECT_NEAR(way.z(), -0.06 * 25 * kDt, 1e-5);
  EXPECT_NEAR(way.head<2>().norm(), 0, 1e-5);
  EXPECT_NEAR(peak_force_, 0, 1e-6);
}

TEST_F(ContactOnArm, AnInsertionReportsItsPeakForceAndFailsAboveItsLimit) {
  ExpectForceLimit(InsertionMaker({}));
}

TEST_F(ContactOnArm, ScrewingReportsItsPeakForceAndFailsAboveItsLimit) {
  ExpectForceLimit(ScrewingMaker({}, kPitch));
}

TEST_F(ContactOnArm, BearsASilentSensorForItsPatienceAlone) {
  ContactStage stage(kinematics_, sensor_, frames_, ScrewingMaker({}, kPitch),
                     &peak_force_);
  Step(stage);
  const Joints q = command_.q;
  reading_.wrench.reset();
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(Step(stage), SkillStage::State::kRunning);
  }
  EXPECT_EQ(command_.q, q);
  EXPECT_EQ(Step(stage), SkillStage::State::kFailed);
  EXPECT_EQ(stage.failure().reason,
            "the wrist force-torque sensor has been silent for more than the "
            "0.05 s allowed (force_sensor.patience_s)");
}

}  // namespace
}  // namespace cell
