#include "services/robot_arm/aim_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cell {

using namespace robot_arm;
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr AimError kError = {0.002, kDegree, 5};

TEST(AimError, ThereIsNoneUnlessAskedFor) {
  EXPECT_TRUE(AimError{}.Of(3).isApprox(Eigen::Isometry3d::Identity(), 0));
}

TEST(AimError, IsTheSameForTheSameRequestOnly) {
  EXPECT_EQ(kError.Of(3).matrix(), kError.Of(3).matrix());
  EXPECT_NE(kError.Of(3).matrix(), kError.Of(4).matrix());
  AimError other = kError;
  other.seed = 6;
  EXPECT_NE(kError.Of(3).matrix(), other.Of(3).matrix());
}

TEST(AimError, LiesSidewaysAndHasTheRootMeanSquareAskedFor) {
  constexpr int kNum = 4000;
  double offsets = 0, angles = 0;
  for (int request = 0; request < kNum; ++request) {
    const Eigen::Isometry3d X_SE = kError.Of(request);
    EXPECT_EQ(X_SE.translation().z(), 0);
    offsets += X_SE.translation().squaredNorm();
    const double angle = Eigen::AngleAxisd(X_SE.linear()).angle();
    angles += angle * angle;
  }
  EXPECT_NEAR(std::sqrt(offsets / kNum), 0.002, 0.0001);
  EXPECT_NEAR(std::sqrt(angles / kNum), kDegree, 0.05 * kDegree);
}

}  // namespace
}  // namespace cell
