#include "common/geometry/part_shape.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace cell {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

Piece Box(const Vector3d& half_extents,
          const Isometry3d& X_OP = Isometry3d::Identity()) {
  Piece piece;
  piece.kind = Piece::Kind::kBox;
  piece.X_OP = X_OP;
  piece.half_extents = half_extents;
  return piece;
}

Piece Cylinder(double radius, double half_length,
               const Isometry3d& X_OP = Isometry3d::Identity()) {
  Piece piece;
  piece.kind = Piece::Kind::kCylinder;
  piece.X_OP = X_OP;
  piece.radius = radius;
  piece.half_length = half_length;
  return piece;
}

// The box as a hull.
Piece Hull(const Vector3d& h, const Isometry3d& X_OP) {
  Piece piece;
  piece.kind = Piece::Kind::kHull;
  for (const double z : {-1., 1.}) {
    for (const auto& [x, y] :
         {std::pair{-1., -1.}, {1., -1.}, {1., 1.}, {-1., 1.}}) {
      piece.vertices.push_back(X_OP *
                               Vector3d(x * h.x(), y * h.y(), z * h.z()));
    }
  }
  piece.faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4},
                 {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return piece;
}

PartShape Shape(std::vector<Piece> pieces) {
  Part part;
  part.name = "thing";
  part.pieces = std::move(pieces);
  return PartShape(part);
}

class Poses {
 public:
  explicit Poses(uint64_t seed) : random_(seed) {}
  Isometry3d Draw(double spread) {
    std::normal_distribution<double> normal;
    const auto n = [&] {
      return normal(random_);
    };
    const Eigen::Quaterniond q(n(), n(), n(), n());
    return Translation3d(spread * Vector3d(n(), n(), n())) * q.normalized();
  }

 private:
  std::mt19937_64 random_;
};

const Isometry3d kIdentity = Isometry3d::Identity();

TEST(PartShape, DistanceOfAlignedBoxesIsTheGap) {
  const PartShape box = Shape({Box({0.01, 0.02, 0.03})});
  for (const double gap : {0.0005, 0.004, 0.0099}) {
    const Isometry3d X_WB(Translation3d(0.02 + gap, 0.005, -0.01));
    EXPECT_NEAR(PartShape::Distance(box, kIdentity, box, X_WB, 0.015), gap,
                1e-6);
  }
}

TEST(PartShape, DistanceOfPenetratingPartsIsZero) {
  const PartShape box = Shape({Box({0.01, 0.02, 0.03})});
  const PartShape pin = Shape({Cylinder(0.004, 0.05)});
  EXPECT_EQ(PartShape::Distance(box, kIdentity, box, kIdentity, 0.015), 0);
  EXPECT_EQ(PartShape::Distance(box, kIdentity, pin, kIdentity, 0.015), 0);
}

TEST(PartShape, BeyondTheCutoffIsTheCutoff) {
  const PartShape box = Shape({Box({0.01, 0.02, 0.03})});
  for (const double x : {0.0351, 0.05, 3.0}) {
    EXPECT_EQ(PartShape::Distance(box, kIdentity, box,
                                  Isometry3d(Translation3d(x, 0, 0)), 0.015),
              0.015);
  }
}

TEST(PartShape, NearestOfAllPiecesCounts) {
  const PartShape fork =
      Shape({Box({0.05, 0.01, 0.01}),
             Box({0.01, 0.01, 0.04}, Isometry3d(Translation3d(0.06, 0, 0)))});
  const PartShape pin = Shape({Cylinder(0.005, 0.02)});
  EXPECT_NEAR(
      PartShape::Distance(fork, kIdentity, pin,
                          Isometry3d(Translation3d(0.06, 0, 0.063)), 0.015),
      0.003, 1e-6);
}

TEST(PartShape, PiecesThatAreNoShapeAreNotThere) {
  Piece guide = Box({0.1, 0.1, 0.1});
  guide.is_shape = false;
  const PartShape box = Shape({Box({0.01, 0.01, 0.01}), guide});
  EXPECT_EQ(PartShape::Distance(box, kIdentity, box,
                                Isometry3d(Translation3d(0.05, 0, 0)), 0.015),
            0.015);
  Part ghost;
  ghost.pieces = {guide};
  EXPECT_THROW(PartShape{ghost}, std::invalid_argument);
}

// Property: distance is symmetric and does not depend on the frame W.
TEST(PartShape, DistanceIsSymmetricAndTheSameInEveryFrame) {
  Poses poses(2);
  const PartShape a = Shape({Box({0.02, 0.01, 0.03}), Cylinder(0.01, 0.05)});
  const PartShape b =
      Shape({Hull({0.03, 0.01, 0.01}, poses.Draw(0.01)), Cylinder(0.02, 0.01)});
  int num_near = 0;
  for (int i = 0; i < 500; ++i) {
    const Isometry3d X_WA = poses.Draw(0.04), X_WB = poses.Draw(0.04);
    const Isometry3d X_VW = poses.Draw(0.5);
    const double d = PartShape::Distance(a, X_WA, b, X_WB, 0.05);
    EXPECT_NEAR(PartShape::Distance(b, X_WB, a, X_WA, 0.05), d, 2e-6);
    EXPECT_NEAR(PartShape::Distance(a, X_VW * X_WA, b, X_VW * X_WB, 0.05), d,
                2e-6);
    num_near += d > 0 && d < 0.05;
  }
  EXPECT_GT(num_near, 50);
}

// Property: bounds cull no pair that matters.
TEST(PartShape, CutoffChangesNothingBelowIt) {
  Poses poses(3);
  std::vector<Piece> pieces;
  for (int i = 0; i < 6; ++i) {
    pieces.push_back(Hull({0.02, 0.005, 0.01}, poses.Draw(0.05)));
  }
  const PartShape a = Shape(pieces);
  const PartShape b = Shape({Cylinder(0.01, 0.04, poses.Draw(0.02))});
  for (int i = 0; i < 500; ++i) {
    const Isometry3d X_WA = poses.Draw(0.07), X_WB = poses.Draw(0.07);
    const double exact = PartShape::Distance(a, X_WA, b, X_WB, 10);
    EXPECT_NEAR(PartShape::Distance(a, X_WA, b, X_WB, 0.015),
                std::min(exact, 0.015), 2e-6);
    const double rough = PartShape::Distance(a, X_WA, b, X_WB, 0.015, 0.004);
    EXPECT_EQ(rough <= 0.004, exact <= 0.004);
  }
}

// Property: a motion changes the distance by at most what its points move.
TEST(PartShape, DistanceIsContinuous) {
  Poses poses(4);
  const PartShape a = Shape({Hull({0.02, 0.03, 0.01}, kIdentity)});
  const PartShape b = Shape({Box({0.02, 0.01, 0.03}), Cylinder(0.01, 0.05)});
  for (int i = 0; i < 300; ++i) {
    const Isometry3d X_WB = poses.Draw(0.04);
    const Vector3d step = poses.Draw(0.001).translation();
    const double before = PartShape::Distance(a, kIdentity, b, X_WB, 1);
    const double after =
        PartShape::Distance(a, kIdentity, b, Translation3d(step) * X_WB, 1);
    EXPECT_LE(std::abs(after - before), step.norm() + 2e-6);
  }
}

TEST(PartShape, PointDistanceOfAHullEqualsThatOfTheSameBox) {
  Poses poses(5);
  const Isometry3d X_OP = poses.Draw(0.02);
  const Vector3d half(0.02, 0.03, 0.01);
  const PartShape box = Shape({Box(half, X_OP)});
  const PartShape hull = Shape({Hull(half, X_OP)});
  for (int i = 0; i < 2000; ++i) {
    const PointCloud point({poses.Draw(0.04).translation()});
    EXPECT_NEAR(box.DistanceTo(point, kIdentity, 1),
                hull.DistanceTo(point, kIdentity, 1), 1e-12);
  }
}

TEST(PartShape, PointDistanceAgreesWithThatOfATinyBall) {
  Poses poses(6);
  const PartShape part = Shape({Hull({0.02, 0.03, 0.01}, poses.Draw(0.02)),
                                Cylinder(0.01, 0.05, poses.Draw(0.02)),
                                Box({0.01, 0.02, 0.01}, poses.Draw(0.02))});
  const PartShape ball = Shape({Box(Vector3d::Constant(1e-9))});
  for (int i = 0; i < 500; ++i) {
    const Isometry3d X_WO = poses.Draw(0.04), X_WB = poses.Draw(0.06);
    EXPECT_NEAR(part.DistanceTo(PointCloud({X_WB.translation()}), X_WO, 0.05),
                PartShape::Distance(part, X_WO, ball, X_WB, 0.05), 2e-6);
  }
}

TEST(PartShape, NoPointsAreFarAway) {
  const PartShape box = Shape({Box({0.01, 0.01, 0.01})});
  EXPECT_EQ(box.DistanceTo(PointCloud({}), kIdentity, 0.015), 0.015);
}

TEST(PartShape, LowestPointOfALyingCylinderIsItsRadiusBelowItsAxis) {
  const PartShape pin = Shape({Cylinder(0.02, 0.05)});
  const double tilt = std::numbers::pi / 2;
  const Isometry3d X_WO =
      Translation3d(0.1, 0, 0.3) * AngleAxisd(tilt, Vector3d::UnitX());
  EXPECT_NEAR(pin.LowestZ(X_WO), 0.28, 1e-12);
  EXPECT_NEAR(pin.LowestZ(Isometry3d(Translation3d(0, 0, 0.3))), 0.25, 1e-12);
}

TEST(PartShape, LowestPointOfAHullEqualsThatOfTheSameBox) {
  Poses poses(7);
  const Isometry3d X_OP = poses.Draw(0.02);
  const PartShape box = Shape({Box({0.02, 0.03, 0.01}, X_OP)});
  const PartShape hull = Shape({Hull({0.02, 0.03, 0.01}, X_OP)});
  for (int i = 0; i < 100; ++i) {
    const Isometry3d X_WO = poses.Draw(0.1);
    EXPECT_NEAR(box.LowestZ(X_WO), hull.LowestZ(X_WO), 1e-12);
  }
}

TEST(PartShape, SlackIsPositiveOnlyForWhatIsContained) {
  const PartShape tray = Shape({Box({0.05, 0.05, 0.02})});
  const PartShape pill = Shape({Cylinder(0.005, 0.01)});
  EXPECT_NEAR(tray.Slack(kIdentity, pill, kIdentity), 0.01, 1e-12);
  EXPECT_NEAR(
      tray.Slack(kIdentity, pill, Isometry3d(Translation3d(0.043, 0, 0))),
      0.002, 1e-12);
  EXPECT_NEAR(
      tray.Slack(kIdentity, pill, Isometry3d(Translation3d(0.048, 0, 0))),
      -0.003, 1e-12);
  EXPECT_LT(pill.Slack(kIdentity, tray, kIdentity), 0);
}

}  // namespace
}  // namespace cell
