#include "services/vtb/thread_engagement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cell {

using namespace vtb;
namespace {

using State = ThreadEngagement::State;

constexpr Thread kThread{"nut", 0.008, 0.009, 0.0012, 0.07};

Eigen::Isometry3d At(double z, double angle, double x = 0) {
  Eigen::Isometry3d X(Eigen::Translation3d(x, 0, z));
  X.linear() =
      Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return X;
}

TEST(ThreadEngagement, TakesHoldOnlyDeepAndAligned) {
  ThreadEngagement thread(kThread);
  thread.Update(At(0.010, 0), true);
  EXPECT_EQ(thread.memory().state, State::kOpen);
  thread.Update(At(0.008, 0, 0.002), true);
  EXPECT_EQ(thread.memory().state, State::kOpen);
  thread.Update(At(0.008, 0), true);
  EXPECT_EQ(thread.memory().state, State::kEngaged);
  EXPECT_DOUBLE_EQ(thread.memory().remaining, 0.008);
}

// Property: one turn clockwise is one pitch, however it is cut into steps.
TEST(ThreadEngagement, AdvancesByThePitchPerTurn) {
  for (const int steps : {5, 50, 500}) {
    ThreadEngagement thread(kThread);
    thread.Update(At(0.009, 1.0), true);
    for (int i = 1; i <= steps; ++i) {
      thread.Update(At(0.009, 1.0 - 2 * std::numbers::pi * i / steps), true);
    }
    EXPECT_NEAR(thread.memory().remaining, 0.001, 1e-12) << steps;
  }
}

TEST(ThreadEngagement, IsFrozenWhenSeatedAndCanBeUndone) {
  ThreadEngagement thread(kThread);
  double angle = 0;
  thread.Update(At(0.001, angle), true);
  for (int i = 0; i < 20; ++i) thread.Update(At(0, angle -= 0.1), true);
  EXPECT_EQ(thread.memory().state, State::kFrozen);
  EXPECT_EQ(thread.memory().remaining, 0);

  thread.Update(At(0, angle), false);
  EXPECT_EQ(thread.memory().state, State::kFrozen);
  for (int i = 0; i < 100; ++i) {
    thread.Update(At(thread.memory().remaining, angle += 0.1), true);
  }
  EXPECT_EQ(thread.memory().state, State::kOpen);
}

TEST(ThreadEngagement, IsFrozenHalfwayWhenReleased) {
  ThreadEngagement thread(kThread);
  thread.Update(At(0.008, 0), true);
  thread.Update(At(0.008, -1), true);
  const double remaining = thread.memory().remaining;
  thread.Update(At(0.008, -1), false);
  EXPECT_EQ(thread.memory().state, State::kFrozen);
  EXPECT_NEAR(thread.X_SO().translation().z(), remaining, 1e-15);
}

}  // namespace
}  // namespace cell
