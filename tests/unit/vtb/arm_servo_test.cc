#include "services/vtb/arm_servo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cell {

using namespace vtb;
namespace {

constexpr double kTick = 0.008;
const Joints kSpeed = Joints::Constant(3.14);  // [rad/s]

ArmServo::Params Immediate() {
  ArmServo::Params params;
  params.dead_ticks = 0;
  return params;
}

// Ratio of the amplitudes of the arm's and the set-point's sine.
double GainAt(double frequency) {
  ArmServo servo(Immediate(), Joints::Constant(1000), Joints::Zero());
  double peak = 0;
  for (int k = 0; k < 2000; ++k) {
    const double t = k * kTick;
    servo.Command(
        Joints::Constant(0.01 * std::sin(2 * std::numbers::pi * frequency * t)),
        false);
    servo.Update(kTick, 0);
    if (k > 1000) peak = std::max(peak, std::abs(servo.position()[0]));
  }
  return peak / 0.01;
}

TEST(ArmServo, FollowsSlowSetPointsAndHalvesThePowerAtItsBandwidth) {
  EXPECT_NEAR(GainAt(0.5), 1, 0.01);
  // A set-point is held for a tick, which costs a little more at 12 Hz.
  EXPECT_NEAR(GainAt(12), 1 / std::numbers::sqrt2, 0.08);
  EXPECT_LT(GainAt(30), 0.4);
}

TEST(ArmServo, NeverMovesFasterThanItsJointsMay) {
  ArmServo::Params params;
  ArmServo servo(params, kSpeed, Joints::Zero());
  Joints before = servo.position();
  for (int k = 0; k < 200; ++k) {
    servo.Command(Joints::Constant(3), false);
    servo.Update(kTick, 0);
    EXPECT_LE((servo.position() - before).cwiseAbs().maxCoeff(),
              kSpeed[0] * kTick + 1e-12);
    EXPECT_LE(servo.velocity().cwiseAbs().maxCoeff(), kSpeed[0]);
    before = servo.position();
  }
  EXPECT_NEAR(servo.position()[5], 3, 1e-3);
}

TEST(ArmServo, StandsByItselfWhenSetPointsStopComing) {
  ArmServo::Params params;
  ArmServo servo(params, kSpeed, Joints::Zero());
  double q = 0;
  for (int k = 0; k < 100; ++k) {
    q += 1.0 * kTick;
    servo.Command(Joints::Constant(q), false);
    servo.Update(kTick, 0);
  }
  for (int k = 0; k < params.patience_ticks; ++k) servo.Update(kTick, 0);
  EXPECT_EQ(servo.state(), ArmServo::State::kFollowing);
  servo.Update(kTick, 0);
  EXPECT_EQ(servo.state(), ArmServo::State::kHolding);
  // At rest where the last set-point was, within 200 ms.
  for (int k = 0; k < 20; ++k) servo.Update(kTick, 0);
  EXPECT_NEAR(servo.position()[0], q, 1e-4);
  EXPECT_LT(servo.velocity().cwiseAbs().maxCoeff(), 1e-3);
}

TEST(ArmServo, StopsForExcessForceUntilItIsCleared) {
  ArmServo::Params params;
  ArmServo servo(params, kSpeed, Joints::Zero());
  servo.Command(Joints::Constant(0.1), false);
  servo.Update(kTick, params.stop_force + 1);
  EXPECT_EQ(servo.state(), ArmServo::State::kStopped);
  for (int k = 0; k < 50; ++k) {
    servo.Command(Joints::Constant(0.1), false);
    servo.Update(kTick, 0);
  }
  EXPECT_EQ(servo.state(), ArmServo::State::kStopped);
  EXPECT_EQ(servo.position(), Joints::Zero());
  servo.Command(Joints::Constant(0.1), true);
  for (int k = 0; k < 50; ++k) {
    servo.Command(Joints::Constant(0.1), false);
    servo.Update(kTick, 0);
  }
  EXPECT_EQ(servo.state(), ArmServo::State::kFollowing);
  EXPECT_NEAR(servo.position()[0], 0.1, 1e-3);
}

TEST(ArmServo, TheDeadTimeDelaysASetPointByWholeTicks) {
  ArmServo::Params params;
  params.dead_ticks = 4;
  ArmServo servo(params, kSpeed, Joints::Zero());
  for (int k = 0; k < 4; ++k) {
    servo.Command(Joints::Constant(0.1), false);
    servo.Update(kTick, 0);
    EXPECT_EQ(servo.position(), Joints::Zero()) << k;
  }
  servo.Update(kTick, 0);
  EXPECT_GT(servo.position()[0], 0);
}

}  // namespace
}  // namespace cell
