#include "common/geometry/pose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace cell {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

TEST(Pose, ComesBackFromAMessageAsItWentIn) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Quaterniond q =
        Eigen::Quaterniond(normal(random), normal(random), normal(random),
                           normal(random))
            .normalized();
    const Isometry3d X =
        Eigen::Translation3d(normal(random), normal(random), normal(random)) *
        q;
    const auto back = PoseFromMessage(PoseToMessage(X));
    ASSERT_TRUE(back);
    EXPECT_TRUE(back->isApprox(X, 1e-12));
    EXPECT_GE(PoseToMessage(X).quat_wxyz[0], 0);
  }
}

TEST(Pose, IsRefusedUnlessFiniteNearAndUnit) {
  const pose_t good = PoseToMessage(Isometry3d::Identity());
  ASSERT_TRUE(PoseFromMessage(good));
  for (const double bad : {kNan, kInf, -kInf, 1e3}) {
    for (int i = 0; i < 3; ++i) {
      pose_t message = good;
      message.position[i] = bad;
      EXPECT_FALSE(PoseFromMessage(message)) << bad;
    }
    for (int i = 0; i < 4; ++i) {
      pose_t message = good;
      message.quat_wxyz[i] = bad;
      EXPECT_FALSE(PoseFromMessage(message)) << bad;
    }
  }
  EXPECT_FALSE(PoseFromMessage(pose_t{})) << "zero quaternion";
}

TEST(Pose, NormalisesAQuaternionThatIsNearlyUnit) {
  pose_t message = PoseToMessage(Isometry3d::Identity());
  message.quat_wxyz[0] = 1 + 5e-5;
  const auto X = PoseFromMessage(message);
  ASSERT_TRUE(X);
  EXPECT_NEAR(X->linear().determinant(), 1, 1e-12);
  message.quat_wxyz[0] = 1 + 2e-4;
  EXPECT_FALSE(PoseFromMessage(message));
}

TEST(Pose, AngleBetweenIsThatOfTheRelativeRotation) {
  const Isometry3d X_WA(AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()));
  for (const double angle : {0.0, 1e-3, 0.5, std::numbers::pi}) {
    const Isometry3d X_WB = X_WA * AngleAxisd(angle, Vector3d::UnitY());
    EXPECT_NEAR(AngleBetween(X_WA, X_WB), angle, 1e-7);
  }
}

}  // namespace
}  // namespace cell
