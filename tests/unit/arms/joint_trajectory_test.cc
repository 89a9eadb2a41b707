// A path in time, within the rates of the joints.
#include "common/arms/joint_trajectory.h"

#include <gmock/gmock.h>

#include <random>

namespace cell {
namespace {

std::vector<Joints> RandomPath(std::mt19937_64& random, int num_waypoints) {
  std::uniform_real_distribution<double> angle(-3, 3);
  std::vector<Joints> path;
  for (int i = 0; i < num_waypoints; ++i) {
    path.push_back(Joints::NullaryExpr([&] { return angle(random); }));
  }
  return path;
}

TEST(JointTrajectory, KeepsToTheRatesAndItsSpeedIsTheDerivative) {
  std::mt19937_64 random(1);
  const JointRates rates;
  constexpr double kStep = 0.002;
  for (int run = 0; run < 40; ++run) {
    const JointTrajectory trajectory(RandomPath(random, 1 + run % 5), rates);
    JointTrajectory::Sample last = trajectory.At(0);
    for (double t = kStep; t < trajectory.duration() + 0.1; t += kStep) {
      const JointTrajectory::Sample now = trajectory.At(t);
      ASSERT_LE(now.dq.cwiseAbs().maxCoeff(), rates.speed + 1e-9);
      ASSERT_LE((now.dq - last.dq).cwiseAbs().maxCoeff(),
                rates.acceleration * kStep + 1e-9);
      ASSERT_LE((now.q - last.q - kStep / 2 * (now.dq + last.dq))
                    .cwiseAbs()
                    .maxCoeff(),
                rates.acceleration * kStep * kStep);
      last = now;
    }
  }
}

TEST(JointTrajectory, BeginsAndEndsAtRestAtItsEnds) {
  std::mt19937_64 random(2);
  const std::vector<Joints> path = RandomPath(random, 3);
  const JointTrajectory trajectory(path);
  for (const double t : {-1.0, 0.0}) {
    EXPECT_EQ(trajectory.At(t).q, path.front());
    EXPECT_EQ(trajectory.At(t).dq, Joints::Zero());
  }
  for (const double t : {trajectory.duration(), 1e9}) {
    EXPECT_EQ(trajectory.At(t).q, path.back());
    EXPECT_EQ(trajectory.At(t).dq, Joints::Zero());
  }
}

TEST(JointTrajectory, PassesItsWaypointsOnStraightLines) {
  std::mt19937_64 random(3);
  const std::vector<Joints> path = RandomPath(random, 4);
  const JointTrajectory trajectory(path);
  std::vector<double> nearest(path.size(), 10);
  for (double t = 0; t <= trajectory.duration(); t += 1e-3) {
    const Joints q = trajectory.At(t).q;
    double off_path = 10;
    for (size_t i = 0; i < path.size(); ++i) {
      nearest[i] = std::min(nearest[i], (q - path[i]).norm());
      if (i == 0) continue;
      const Joints way = path[i] - path[i - 1];
      const double s =
          std::clamp((q - path[i - 1]).dot(way) / way.squaredNorm(), 0.0, 1.0);
      off_path = std::min(off_path, (q - path[i - 1] - s * way).norm());
    }
    ASSERT_LT(off_path, 1e-9);
  }
  for (const double distance : nearest) EXPECT_LT(distance, 1e-4);
}

TEST(JointTrajectory, IsAsFastAsTheRatesAllow) {
  const JointRates rates{1.0, 2.0};
  // 0.5 s to speed up, 0.5 s to slow down, 0.25 rad each; the rest at speed.
  const JointTrajectory far({Joints::Zero(), 2 * Joints::Unit(1)}, rates);
  EXPECT_NEAR(far.duration(), 2.5, 1e-12);
  // Never at full speed: half the way in sqrt(2 * 0.1 / 2) s.
  const JointTrajectory near({Joints::Zero(), 0.2 * Joints::Unit(1)}, rates);
  EXPECT_NEAR(near.duration(), 2 * std::sqrt(0.1), 1e-12);
}

TEST(JointTrajectory, OfOnePointStandsStill) {
  const JointTrajectory trajectory({Joints::Ones(), Joints::Ones()});
  EXPECT_EQ(trajectory.duration(), 0);
  EXPECT_EQ(trajectory.At(0.3).q, Joints::Ones());
}

TEST(JointTrajectory, RefusesNoPathAndNoSpeed) {
  EXPECT_THROW(JointTrajectory({}), std::invalid_argument);
  EXPECT_THROW(JointTrajectory({Joints::Zero()}, {0, 1}),
               std::invalid_argument);
}

}  // namespace
}  // namespace cell
