#include "services/vtb/hand_path.h"

#include <gtest/gtest.h>

#include <random>

namespace cell {

using namespace vtb;
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Isometry3d Random(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Isometry3d X = Isometry3d::Identity();
  X.translation() = Vector3d(0.4 * unit(random), 0.4 * unit(random),
                             0.2 + 0.1 * unit(random));
  X.linear() =
      Eigen::AngleAxisd(2 * unit(random),
                        Vector3d(unit(random), unit(random), 1.1).normalized())
          .toRotationMatrix();
  return X;
}

TEST(MinimumJerk, HasItsInverse) {
  for (double value = 0.01; value < 1; value += 0.01) {
    EXPECT_NEAR(MinimumJerk(MinimumJerkPhase(value)), value, 1e-9);
  }
}

// Property: it ends where it should, and below the clear height it is above one
// of its two ends.
TEST(HandPath, GoesAcrossOnlyAboveTheClearHeight) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 50; ++i) {
    const Isometry3d from = Random(random), to = Random(random);
    constexpr double kClear = 0.35, kTop = 0.40;
    const HandPath path =
        HandPath::Over(from, to, kClear, kTop, 0.03, HandPath::Speeds{});
    EXPECT_TRUE(path.At(0).isApprox(from, 1e-9));
    EXPECT_TRUE(path.At(path.duration()).isApprox(to, 1e-9));
    for (double t = 0; t < path.duration(); t += 0.01) {
      const Vector3d p = path.At(t).translation();
      EXPECT_LT(p.z(), kTop + 1e-9);
      if (p.z() > kClear) continue;
      const double off = std::min((p - from.translation()).head<2>().norm(),
                                  (p - to.translation()).head<2>().norm());
      EXPECT_LT(off, 1e-4) << "at " << t << " s, height " << p.z();
    }
  }
}

// Property: about an axis, whatever the angle, its points stay and the hand
// keeps its place beside it.
TEST(HandPath, AboutAnAxisKeepsItsDistance) {
  const Eigen::Vector3d p_W(0.1, 0.2, 0.3);
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
  Eigen::Isometry3d from = Eigen::Isometry3d::Identity();
  from.translation() << 0.4, -0.1, 0.2;
  for (const double angle : {-2.0, -1e-6, 0.0, 0.5, 1.8}) {
    const HandPath path = HandPath::About(from, p_W, axis, angle, 2);
    EXPECT_EQ(path.duration(), 2);
    EXPECT_TRUE(path.At(0).isApprox(from, 1e-12));
    const Eigen::Vector3d p_before = from.inverse() * p_W;
    for (const double time : {0.3, 1.0, 2.0, 5.0}) {
      const Eigen::Vector3d p_now = path.At(time).inverse() * p_W;
      EXPECT_TRUE(p_now.isApprox(p_before, 1e-12));
    }
    const Eigen::Matrix3d turn =
        path.At(2).linear() * from.linear().transpose();
    EXPECT_TRUE(turn.isApprox(Eigen::AngleAxisd(angle, axis).toRotationMatrix(),
                              1e-12));
  }
}

}  // namespace
}  // namespace cell
