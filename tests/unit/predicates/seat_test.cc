#include "common/predicates/seat.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "common/geometry/degree.h"

namespace cell {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr SeatTolerance kTolerance{0.0008, 0.003, 1 * kDegree, 5 * kDegree};

Isometry3d Turn(double angle, const Vector3d& axis) {
  return Isometry3d(AngleAxisd(angle, axis));
}

TEST(Seat, EachToleranceHoldsJustInsideAndNotJustOutside) {
  const Vector3d z = Vector3d::UnitZ();
  const Vector3d diagonal = Vector3d(1, 1, 0).normalized();
  for (const double sign : {-1., 1.}) {
    for (const auto& [share, is_seated] :
         {std::pair{0.99, true}, {1.01, false}}) {
      const double s = sign * share;
      const auto seated = [](const Isometry3d& X_SO) {
        return IsSeated(X_SO, 1, kTolerance);
      };
      EXPECT_EQ(seated(Isometry3d(Translation3d(0, 0, s * 0.0008))), is_seated);
      EXPECT_EQ(seated(Isometry3d(Translation3d(s * 0.003 * diagonal))),
                is_seated);
      EXPECT_EQ(seated(Turn(s * 1 * kDegree, diagonal)), is_seated);
      EXPECT_EQ(seated(Turn(s * 5 * kDegree, z)), is_seated);
    }
  }
}

TEST(Seat, UpsideDownIsNotSeated) {
  EXPECT_FALSE(
      IsSeated(Turn(std::numbers::pi, Vector3d::UnitX()), 0, kTolerance));
}

// Property: a rotation of the symmetry changes nothing.
TEST(Seat, SymmetryCannotBeSeen) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const int order = i % 7;
    const double angle = order == 0 ? 10 * unit(random)
                                    : 2 * std::numbers::pi / order * (i % 11);
    const Isometry3d turn = Turn(angle, Vector3d::UnitZ());
    const Isometry3d X_SO =
        Translation3d(0.002 * unit(random), 0.002 * unit(random),
                      0.001 * unit(random)) *
        Turn(0.03 * unit(random),
             Vector3d(unit(random), unit(random), 0).normalized()) *
        Turn(0.15 * unit(random), Vector3d::UnitZ());
    EXPECT_EQ(IsSeated(X_SO, order, kTolerance),
              IsSeated(X_SO * turn, order, kTolerance));
    EXPECT_NEAR(VisibleAngle(X_SO, order), VisibleAngle(X_SO * turn, order),
                1e-6);
  }
}

TEST(Seat, ATurnBetweenTwoPositionsOfTheSymmetryIsSeen) {
  const Isometry3d X = Turn(45 * kDegree, Vector3d::UnitZ());
  EXPECT_FALSE(IsSeated(X, 4, kTolerance));
  EXPECT_TRUE(IsSeated(X, 8, kTolerance));
  EXPECT_TRUE(IsSeated(X, 0, kTolerance));
  EXPECT_NEAR(VisibleAngle(X, 4), 45 * kDegree, 1e-9);
  EXPECT_NEAR(VisibleAngle(X, 0), 0, 1e-9);
}

TEST(Seat, TiltIsThatOfTheAxisEitherWayUp) {
  for (const double tilt : {0., 30., 89.}) {
    const Isometry3d X = Turn(tilt * kDegree, Vector3d::UnitY());
    EXPECT_NEAR(TiltOf(X), tilt * kDegree, 1e-9);
    EXPECT_NEAR(TiltOf(X * Turn(std::numbers::pi, Vector3d::UnitX())),
                tilt * kDegree, 1e-9);
  }
}

}  // namespace
}  // namespace cell
