// How a part in contact yields to what pushes it, and slows down.
#include "services/robot_arm/contact/admittance.h"

#include <gmock/gmock.h>

#include <random>

#include "services/robot_arm/contact/slow_down.h"
#include "tests/unit/robot_arm/control_period.h"

namespace cell {

using namespace robot_arm;
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(Admittance, FollowsEquation2WhateverPushes) {
  const Admittance::Params params{.kp = 2e-5, .ki = 4e-4, .max_drift = 1};
  Admittance admittance(params);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> force(-20, 20);
  Vector2d impulse = Vector2d::Zero();
  for (int i = 0; i < 200; ++i) {
    const ContactWrench contact{{force(random), force(random), 15}};
    admittance.Step(contact, kDt);
    const Vector2d f = contact.force.head<2>();
    impulse += f * kDt;
    EXPECT_NEAR((admittance.proportional() - params.kp * f).norm(), 0, 1e-15);
    EXPECT_NEAR((admittance.integral() - params.ki * impulse).norm(), 0, 1e-12);
  }
}

TEST(Admittance, KeepsWhereItHasYieldedToWhenNothingPushesAnyMore) {
  Admittance admittance({});
  admittance.Step({{10, 0, 0}, {0, 0, 0.5}}, kDt);
  const Vector2d integral = admittance.integral();
  admittance.Step({}, kDt);
  EXPECT_EQ(admittance.proportional(), Vector2d::Zero());
  EXPECT_EQ(admittance.integral(), integral);
  EXPECT_GT(integral.x(), 0);
  EXPECT_NEAR(admittance.Turn().z(), 0.06 * 0.5 * kDt, 1e-12);
}

TEST(Admittance, BoundsHowFarItDriftsAndTurns) {
  const Admittance::Params params;
  Admittance admittance(params);
  for (int i = 0; i < 2000; ++i) {
    admittance.Step({{30, -40, 0}, {0, 2, 0}}, kDt);
  }
  EXPECT_NEAR(admittance.integral().norm(), params.max_drift, 1e-9);
  EXPECT_NEAR(admittance.integral().x() / admittance.integral().y(), -0.75,
              1e-9);
  EXPECT_NEAR(admittance.Turn().y(), params.max_turn + 2 * params.kp_turn,
              1e-9);
}

TEST(Admittance, AlongTheAxisIsSlowedDownTowardsTheSeatAlone) {
  const Admittance admittance({.ki = 1e-3});
  EXPECT_DOUBLE_EQ(admittance.AxialStep(-5, 1, kDt), -5e-3 * kDt);
  EXPECT_DOUBLE_EQ(admittance.AxialStep(-5, 0.5, kDt), -2.5e-3 * kDt);
  EXPECT_DOUBLE_EQ(admittance.AxialStep(5, 0.5, kDt), 5e-3 * kDt);
}

TEST(SlowDown, BeginsBeyondTheDeadZone) {
  const SlowDown slow_down({.gain = 0.5, .dead = 3});
  EXPECT_EQ(slow_down.Rate({0, 0}), 1);
  EXPECT_EQ(slow_down.Rate({0, -3}), 1);
  EXPECT_DOUBLE_EQ(slow_down.Rate({3, 4}), 0.5);
  EXPECT_LT(slow_down.Rate({30, 40}), slow_down.Rate({3, 4}));
  EXPECT_GT(slow_down.Rate({1e6, 0}), 0);
}

TEST(SlowDown, IsOffWithoutAGain) {
  EXPECT_EQ(SlowDown({.gain = 0}).Rate({100, 0}), 1);
}

}  // namespace
}  // namespace cell
