// What contact motions follow, and when they are over.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <numbers>

#include "services/robot_arm/contact/contact_limits.h"
#include "services/robot_arm/contact/seated_termination.h"
#include "services/robot_arm/contact/straight_feed.h"
#include "services/robot_arm/contact/thread_feed.h"
#include "services/robot_arm/contact/tightened_termination.h"
#include "tests/unit/robot_arm/control_period.h"

namespace cell {

using namespace robot_arm;
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kHigh = 0.1, kLow = 0.02;  // [m]

ContactState At(double commanded_height, double force = 0) {
  return {.contact = {{0, 0, force}}, .commanded_height = commanded_height};
}

class StraightFeedTest : public testing::Test {
 protected:
  MotionReference::Step Advance(double height, double force, int times = 1) {
    MotionReference::Step step;
    for (int i = 0; i < times; ++i) {
      step = feed_.Advance(At(height, force), 1, kDt);
    }
    return step;
  }

  StraightFeed feed_{{.push = 10, .free_feed = 0.05, .touch_feed = 0.01}};
};

TEST_F(StraightFeedTest, GoesFastWhereNothingIsExpectedAndThenSlowly) {
  EXPECT_EQ(Advance(kHigh, 0).translation, Vector3d(0, 0, -0.05 * kDt));
  EXPECT_EQ(Advance(kLow, 0).translation, Vector3d(0, 0, -0.01 * kDt));
  EXPECT_FALSE(Advance(kLow, 0).is_pressing);
}

TEST_F(StraightFeedTest, IsSlowedDownByTheRate) {
  EXPECT_DOUBLE_EQ(feed_.Advance(At(kHigh), 0.5, kDt).translation.z(),
                   -0.025 * kDt);
}

TEST_F(StraightFeedTest, StandsAndPressesInContact) {
  const auto step = Advance(kLow, 4);
  EXPECT_EQ(step.translation, Vector3d::Zero());
  EXPECT_TRUE(step.is_pressing);
  EXPECT_EQ(feed_.push(), 10);
}

TEST_F(StraightFeedTest, TakesNoBounceForTheEndOfContact) {
  Advance(kLow, 4);
  EXPECT_TRUE(Advance(kLow, 0, 20).is_pressing);
  EXPECT_TRUE(Advance(kLow, 2).is_pressing);
  EXPECT_TRUE(Advance(kLow, 0, 20).is_pressing);
  EXPECT_FALSE(Advance(kLow, 0, 10).is_pressing);
}

TEST(ThreadFeed, SinksByThePitchInATurn) {
  const auto begin =
      AngleAxisd(0.3, Vector3d(0.1, 0, 1).normalized()).toRotationMatrix();
  for (const double rate : {1.0, 0.25}) {
    ThreadFeed feed({.push = 2, .rate = 1.3}, 0.008, begin);
    double z = 0;
    MotionReference::Step step;
    while (step.turned < 2 * std::numbers::pi) {
      step = feed.Advance(At(kLow), rate, kDt);
      z += step.translation.z();
      EXPECT_TRUE(step.is_pressing);
    }
    EXPECT_NEAR(z, -0.008 * step.turned / (2 * std::numbers::pi), 1e-9);
    const Eigen::Matrix3d turned =
        AngleAxisd(-step.turned, Vector3d::UnitZ()) * begin;
    EXPECT_TRUE(step.R_SO.isApprox(turned, 1e-9));
  }
}

ContactState Stalled(double height) {
  return {.contact = {{0, 3, 4}}, .height = height, .is_stalled = true};
}

TEST(SeatedTermination, GoesOnUntilThePartStalls) {
  const SeatedTermination seated({});
  ContactState state = Stalled(0);
  state.is_stalled = false;
  EXPECT_EQ(seated.Judge(state).outcome, Termination::Outcome::kGoOn);
}

TEST(SeatedTermination, IsDoneNearTheSeatAndSomewhatDeeper) {
  const SeatedTermination seated(
      {.height = 0.005, .tolerance = 0.001, .give = 0.002});
  EXPECT_EQ(seated.Judge(Stalled(0.0059)).outcome, Termination::Outcome::kDone);
  EXPECT_EQ(seated.Judge(Stalled(0.0021)).outcome, Termination::Outcome::kDone);
  EXPECT_EQ(seated.Judge(Stalled(0.0061)).outcome,
            Termination::Outcome::kStuck);
  EXPECT_EQ(seated.Judge(Stalled(0.0019)).outcome,
            Termination::Outcome::kStuck);
}

TEST(SeatedTermination, ReportsHowFarFromItsSeatItIsStuck) {
  EXPECT_EQ(SeatedTermination({}).Judge(Stalled(0.0123)).reason,
            "it is stuck 12.3 mm from its seat, 0.8 mm allowed "
            "(seat.tolerance_mm), by 5.0 N at the wrist sensor");
}

ContactState Turned(double angle, double torque) {
  return {
      .contact = {.torque = {0, 0, torque}}, .height = 0.002, .turned = angle};
}

TEST(TightenedTermination, IsDoneByTorqueEitherWayWhenItHasTurnedEnough) {
  const TightenedTermination tight({});
  EXPECT_EQ(tight.Judge(Turned(5, 0.3)).outcome, Termination::Outcome::kGoOn);
  EXPECT_EQ(tight.Judge(Turned(5, 0.5)).outcome, Termination::Outcome::kDone);
  EXPECT_EQ(tight.Judge(Turned(5, -0.5)).outcome, Termination::Outcome::kDone);
}

TEST(TightenedTermination, CallsAThreadThatIsTightTooEarlyJammed) {
  const auto verdict = TightenedTermination({}).Judge(Turned(1, -0.5));
  EXPECT_EQ(verdict.outcome, Termination::Outcome::kFailed);
  EXPECT_EQ(
      verdict.reason,
      "the thread has jammed 2.0 mm from its seat: the wrist sensor "
      "measured 0.5 N m, more than the 0.4 N m allowed (tight.torque_nm) "
      "after 57 deg, at least 258 deg are required (tight.min_angle_deg)");
}

TEST(TightenedTermination, CallsAThreadThatIsNeverTightLoose) {
  const auto verdict = TightenedTermination({}).Judge(Turned(8.5, 0.1));
  EXPECT_EQ(verdict.outcome, Termination::Outcome::kFailed);
  EXPECT_THAT(
      verdict.reason,
      HasSubstr(
          "0.10 N m of the 0.40 N m required (tight.torque_nm): the thread "
          "does not hold"));
}

TEST(ContactLimits, SayWhichOneIsExceeded) {
  const ContactLimits limits({.force = 50, .time = 10});
  EXPECT_FALSE(limits.WhyExceeded(50, 10, 0.01));
  EXPECT_EQ(limits.WhyExceeded(51, 1, 0.01),
            "the wrist sensor measured 51.0 N, more than the 50.0 N allowed "
            "(limits.force_n)");
  EXPECT_EQ(limits.WhyExceeded(5, 10.1, 0.0123),
            "it is 12.3 mm from its seat after the 10 s allowed "
            "(limits.time_s)");
}

}  // namespace
}  // namespace cell
