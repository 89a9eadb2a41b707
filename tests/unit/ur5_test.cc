#include "common/arms/ur5.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace cell {
namespace {

Joints Draw(std::mt19937_64& random, double limit = 3.1) {
  Joints q;
  for (int i = 0; i < 6; ++i) {
    q[i] = std::uniform_real_distribution<double>(-limit, limit)(random);
  }
  return q;
}

TEST(Ur5, StretchedOutItReachesAsFarAsItsLinksAreLong) {
  const Eigen::Vector3d p = ur5::FlangePose(Joints::Zero()).translation();
  EXPECT_NEAR(p.x(), -(0.425 + 0.39225), 1e-12);
  EXPECT_NEAR(p.y(), -(0.10915 + 0.0823), 1e-12);
  EXPECT_NEAR(p.z(), 0.089159 - 0.09465, 1e-12);
}

TEST(Ur5, TheInverseHoldsTheJointsThatMadeThePose) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 500; ++i) {
    const Joints q = Draw(random);
    if (ur5::Dexterity(q) < 0.02) continue;
    const auto solutions = ur5::Inverse(ur5::FlangePose(q));
    const bool is_found = std::ranges::any_of(solutions, [&](const Joints& s) {
      return (ur5::Nearest(s, q) - q).cwiseAbs().maxCoeff() < 1e-6;
    });
    EXPECT_TRUE(is_found) << q.transpose() << " among " << solutions.size();
  }
}

TEST(Ur5, EverySolutionBringsTheFlangeThere) {
  std::mt19937_64 random(2);
  size_t num = 0;
  for (int i = 0; i < 300; ++i) {
    const Eigen::Isometry3d X = ur5::FlangePose(Draw(random));
    for (const Joints& q : ur5::Inverse(X)) {
      ++num;
      EXPECT_LT((ur5::FlangePose(q).matrix() - X.matrix()).norm(), 1e-5);
      EXPECT_LE(q.cwiseAbs().maxCoeff(), 3.1416);
    }
  }
  EXPECT_GT(num, 300u * 2);
}

TEST(Ur5, OutOfReachHasNoSolution) {
  const Eigen::Isometry3d far(Eigen::Translation3d(1.2, 0, 0.1));
  EXPECT_TRUE(ur5::Inverse(far).empty());
}

TEST(Ur5, TheJacobianIsTheDerivativeOfThePose) {
  std::mt19937_64 random(3);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 50; ++i) {
    const Joints q = Draw(random);
    const auto J = ur5::Jacobian(q);
    for (int j = 0; j < 6; ++j) {
      Joints a = q, b = q;
      a[j] -= kStep;
      b[j] += kStep;
      const Eigen::Isometry3d A = ur5::FlangePose(a), B = ur5::FlangePose(b);
      const Eigen::Vector3d v =
          (B.translation() - A.translation()) / (2 * kStep);
      const Eigen::AngleAxisd turn(B.linear() * A.linear().transpose());
      const Eigen::Vector3d w = turn.angle() * turn.axis() / (2 * kStep);
      EXPECT_LT((J.block<3, 1>(3, j) - v).norm(), 1e-5);
      EXPECT_LT((J.block<3, 1>(0, j) - w).norm(), 1e-5);
    }
  }
}

TEST(Ur5, NearestStaysWithinTheLimits) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 200; ++i) {
    const Joints q = ur5::Nearest(Draw(random), Draw(random, 6.2));
    EXPECT_LE(q.cwiseAbs().maxCoeff(), ur5::kJointLimit + 1e-12);
  }
}

}  // namespace
}  // namespace cell
