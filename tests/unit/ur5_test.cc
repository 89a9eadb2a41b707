// The kinematics of the arms: forward and inverse undo each other.
#include "common/arms/ur5.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace cell::ur5 {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

Joints RandomJoints(std::mt19937_64& random, double limit = kPi) {
  std::uniform_real_distribution<double> angle(-limit, limit);
  Joints q;
  for (int i = 0; i < 6; ++i) q[i] = angle(random);
  return q;
}

double Apart(const Joints& a, const Joints& b) {
  double apart = 0;
  for (int i = 0; i < 6; ++i) {
    apart = std::max(apart, std::abs(std::remainder(a[i] - b[i], 2 * kPi)));
  }
  return apart;
}

TEST(Ur5, StandsAsItsTableSaysWhenAllAnglesAreZero) {
  const Isometry3d X_BF = FlangePose(Joints::Zero());
  EXPECT_NEAR(X_BF.translation().x(), kA2 + kA3, 1e-12);
  EXPECT_NEAR(X_BF.translation().y(), -kD4 - kD6, 1e-12);
  EXPECT_NEAR(X_BF.translation().z(), kD1 - kD5, 1e-12);
  EXPECT_TRUE(X_BF.linear().col(2).isApprox(-Vector3d::UnitY(), 1e-12));
}

TEST(Ur5, EverySolutionReachesThePose) {
  std::mt19937_64 random(1);
  size_t most = 0;
  for (int i = 0; i < 5000; ++i) {
    const Isometry3d X_BF = FlangePose(RandomJoints(random));
    const auto solutions = SolveInverse(X_BF);
    most = std::max(most, solutions.size());
    for (const Joints& q : solutions) {
      ASSERT_TRUE(FlangePose(q).isApprox(X_BF, 1e-7)) << q.transpose();
    }
  }
  EXPECT_EQ(most, 8u);
}

TEST(Ur5, TheSolutionsContainTheJointsThatThePoseCameFrom) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 5000; ++i) {
    const Joints q = RandomJoints(random);
    double nearest = 10;
    for (const Joints& solution : SolveInverse(FlangePose(q))) {
      nearest = std::min(nearest, Apart(solution, q));
    }
    ASSERT_LT(nearest, 1e-5) << q.transpose();
  }
}

TEST(Ur5, EachSolutionOfARegularPoseIsABranchOfItsOwn) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 1000; ++i) {
    const Joints q = RandomJoints(random);
    if (!IsRegular(q)) continue;
    const auto solutions = SolveInverse(FlangePose(q));
    for (size_t a = 0; a < solutions.size(); ++a) {
      for (size_t b = a + 1; b < solutions.size(); ++b) {
        if (!IsRegular(solutions[a]) || !IsRegular(solutions[b])) continue;
        ASSERT_NE(BranchOf(solutions[a]), BranchOf(solutions[b]));
      }
    }
  }
}

TEST(Ur5, AStraightWristLeavesTheLastAngleToTheCaller) {
  Joints q;
  q << 0.3, -1.2, 1.1, -0.4, 0, 0.7;
  const auto solutions = SolveInverse(FlangePose(q), 0.7);
  ASSERT_FALSE(solutions.empty());
  for (const Joints& solution : solutions) {
    EXPECT_TRUE(FlangePose(solution).isApprox(FlangePose(q), 1e-6));
  }
  EXPECT_TRUE(std::ranges::any_of(solutions, [&](const Joints& solution) {
    return Apart(solution, q) < 1e-6;
  }));
}

TEST(Ur5, BeyondItsReachThereIsNoSolution) {
  Isometry3d X_BF = Isometry3d::Identity();
  X_BF.translation() << 1.2, 0, 0.3;
  EXPECT_TRUE(SolveInverse(X_BF).empty());
  X_BF.translation() << 0, 0.02, 0.3;  // inside the shoulder's column
  EXPECT_TRUE(SolveInverse(X_BF).empty());
}

TEST(Ur5, TheJacobianIsTheDerivativeOfThePose) {
  std::mt19937_64 random(4);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const Joints q = RandomJoints(random);
    const JacobianMatrix J = Jacobian(q);
    for (int joint = 0; joint < 6; ++joint) {
      const Joints step = kStep * Joints::Unit(joint);
      const Isometry3d after = FlangePose(q + step);
      const Isometry3d before = FlangePose(q - step);
      const Eigen::AngleAxisd turned(after.linear() *
                                     before.linear().transpose());
      Eigen::Matrix<double, 6, 1> V;
      V << turned.axis() * turned.angle(),
          after.translation() - before.translation();
      ASSERT_LT((V / (2 * kStep) - J.col(joint)).norm(), 1e-6);
    }
  }
}

TEST(Ur5, RegularityIsTheDeterminantOfTheJacobian) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 500; ++i) {
    const Joints q = RandomJoints(random);
    ASSERT_NEAR(RegularityOf(q).determinant,
                std::abs(Jacobian(q).determinant()), 1e-12);
  }
}

TEST(Ur5, TheNearestCopyIsWithinTheLimitsAndHalfATurn) {
  std::mt19937_64 random(6);
  for (int i = 0; i < 1000; ++i) {
    const Joints seed = RandomJoints(random, kJointLimit);
    const Joints q = RandomJoints(random, kJointLimit);
    const Joints near = NearestTo(seed, q);
    ASSERT_TRUE(IsWithinLimits(near));
    ASSERT_LT(Apart(near, q), 1e-9);
    for (int j = 0; j < 6; ++j) {
      if (std::abs(seed[j]) < kPi) {
        ASSERT_LE(std::abs(near[j] - seed[j]), kPi + 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace cell::ur5
