#include "services/vtb/oriented_box.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace cell::vtb {
namespace {

using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

class OrientedBoxes : public testing::Test {
 protected:
  double Uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector3d Point(double size) {
    const double x = Uniform(-size, size), y = Uniform(-size, size);
    return {x, y, Uniform(-size, size)};
  }
  Isometry3d Pose(double size) {
    Isometry3d X = Isometry3d::Identity();
    X.translation() = Point(size);
    const double w = Uniform(-1, 1), x = Uniform(-1, 1), y = Uniform(-1, 1);
    X.linear() =
        Quaterniond(w, x, y, Uniform(-1, 1)).normalized().toRotationMatrix();
    return X;
  }
  OrientedBox Box() {
    const double x = Uniform(0.01, 0.3), y = Uniform(0.01, 0.3);
    return {Pose(0.5), {x, y, Uniform(0.01, 0.3)}};
  }
  Vector3d PointIn(const OrientedBox& box) {
    return box.X_AB * box.half_extents.cwiseProduct(Point(1));
  }
  /// [m] At least as much as between the boxes.
  double DistanceOfPoints(const OrientedBox& a, const OrientedBox& b,
                          const Isometry3d& X_AC) {
    double distance = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 20; ++i) {
      const Vector3d p_a =
          a.X_AB.inverse() * (X_AC * PointIn(b));  // in the frame of box a
      const Vector3d nearest =
          p_a.cwiseMax(-a.half_extents).cwiseMin(a.half_extents);
      distance = std::min(distance, (p_a - nearest).norm());
    }
    return distance;
  }

  std::mt19937_64 random_{3};
};

TEST_F(OrientedBoxes, NoneThatIsNearIsMissed) {
  int num_near = 0;
  for (int i = 0; i < 2000; ++i) {
    const OrientedBox a = Box(), b = Box();
    const Isometry3d X_AC = Pose(0.5);
    const double distance = Uniform(0, 0.1);
    if (DistanceOfPoints(a, b, X_AC) > distance) continue;
    ++num_near;
    EXPECT_TRUE(MayBeWithin(a, b, X_AC, distance)) << i;
    EXPECT_TRUE(MayBeWithin(b, a, X_AC.inverse(), distance)) << i;
  }
  EXPECT_GT(num_near, 150);
}

TEST_F(OrientedBoxes, FacesAreFoundToTheMicrometre) {
  for (int i = 0; i < 200; ++i) {
    const OrientedBox a = Box();
    OrientedBox b = a;
    const double gap = Uniform(0, 0.05);
    const Vector3d shift(0, 2 * a.half_extents.y() + gap, 0);
    b.X_AB = a.X_AB * Eigen::Translation3d(shift);
    const Isometry3d X_AC = Isometry3d::Identity();
    EXPECT_TRUE(MayBeWithin(a, b, X_AC, gap + 1e-6)) << i;
    EXPECT_FALSE(MayBeWithin(a, b, X_AC, gap - 1e-6)) << i;
  }
}

TEST_F(OrientedBoxes, NoCornerIsBeyondItsReach) {
  for (int i = 0; i < 200; ++i) {
    const OrientedBox box = Box();
    EXPECT_LE(PointIn(box).norm(), box.Reach());
  }
}

}  // namespace
}  // namespace cell::vtb
