// How a stalled part is detected, and how it searches for the way in.
#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <vector>

#include "services/robot_arm/contact/dither.h"
#include "services/robot_arm/contact/spiral_search.h"
#include "services/robot_arm/contact/stall_detector.h"
#include "tests/unit/robot_arm/control_period.h"

namespace cell {

using namespace robot_arm;
namespace {

using Eigen::Vector2d;

constexpr double kHeight = 0.02;

/// Of the first spiral.
std::vector<Vector2d> Path(const SpiralSearch::Params& params) {
  SpiralSearch search(params);
  search.Begin(kHeight);
  std::vector<Vector2d> path;
  double radius = 0;
  while (search.Circle().norm() >= radius - 1e-12) {
    radius = search.Circle().norm();
    path.push_back(search.Circle());
    search.Step(kHeight, kDt);
  }
  return path;
}

TEST(SpiralSearch, DoesNothingUntilItBegins) {
  SpiralSearch search({});
  EXPECT_EQ(search.Step(0, kDt), SpiralSearch::State::kIdle);
  EXPECT_EQ(search.Circle(), Vector2d::Zero());
}

TEST(SpiralSearch, PassesEveryPlaceOfItsDiscWithinAPitch) {
  const SpiralSearch::Params params;
  const auto path = Path(params);
  for (double x = -0.004; x <= 0.004; x += 0.0005) {
    for (double y = -0.004; y <= 0.004; y += 0.0005) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vector2d& p : path) {
        nearest = std::min(nearest, (p - Vector2d(x, y)).norm());
      }
      EXPECT_LT(nearest, params.pitch) << x << ", " << y;
    }
  }
}

TEST(SpiralSearch, MovesAtItsSpeed) {
  const SpiralSearch::Params params;
  const auto path = Path(params);
  for (size_t i = 1; i < path.size(); ++i) {
    EXPECT_LT((path[i] - path[i - 1]).norm(), 1.3 * params.speed * kDt);
  }
}

TEST(SpiralSearch, MakesTheMiddleOfWhereThePartSinksIn) {
  SpiralSearch search({});
  search.Begin(kHeight);
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(search.Step(kHeight, kDt), SpiralSearch::State::kSearching);
  }
  const Vector2d there = search.Circle();
  EXPECT_GT(there.norm(), 0.0005);
  EXPECT_EQ(search.Step(kHeight - 0.0006, kDt),
            SpiralSearch::State::kSearching);
  const Vector2d found = search.Circle();
  EXPECT_EQ(search.Step(kHeight - 0.0008, kDt), SpiralSearch::State::kFound);
  EXPECT_EQ(search.middle(), found);
  EXPECT_EQ(search.Circle(), Vector2d::Zero());
  EXPECT_FALSE(search.is_searching());
}

TEST(SpiralSearch, GivesUpAfterAsManySpiralsAsAllowedWithoutAJump) {
  const SpiralSearch::Params params{.radius = 0.002, .max_spirals = 3};
  SpiralSearch search(params);
  search.Begin(kHeight);
  int num_starts = 0;
  Vector2d last = Vector2d::Zero();
  while (search.Step(kHeight, kDt) == SpiralSearch::State::kSearching) {
    const Vector2d now = search.Circle();
    EXPECT_LT((now - last).norm(), 1.3 * params.speed * kDt);
    EXPECT_LT(now.norm(), params.radius + params.pitch);
    if (now.norm() > 0 && last.norm() == 0) ++num_starts;
    last = now;
    ASSERT_LE(num_starts, params.max_spirals);
  }
  EXPECT_EQ(num_starts, params.max_spirals);
}

TEST(SpiralSearch, FindsOnItsWayBackToo) {
  SpiralSearch search({});
  search.Begin(kHeight);
  double radius = 0;
  while (search.Circle().norm() >= radius - 1e-9) {
    radius = search.Circle().norm();
    search.Step(kHeight, kDt);
  }
  const Vector2d there = search.Circle();
  EXPECT_EQ(search.Step(kHeight - 0.001, kDt), SpiralSearch::State::kFound);
  EXPECT_EQ(search.middle(), there);
}

TEST(SpiralSearch, IsOffWithoutSpirals) {
  EXPECT_FALSE(SpiralSearch({.max_spirals = 0}).is_enabled());
  EXPECT_TRUE(SpiralSearch({}).is_enabled());
}

TEST(Dither, ComesAndGoesGently) {
  const Dither::Params params{.yaw = 0.03, .tilt = 0.01};
  Dither dither(params);
  Eigen::Vector3d last = dither.Turn(0);
  EXPECT_EQ(last, Eigen::Vector3d::Zero());
  double yaw = 0, tilt = 0;
  for (int i = 1; i < 400; ++i) {
    dither.Step(i < 300, kDt);
    const Eigen::Vector3d turn = dither.Turn(i * kDt);
    EXPECT_LT((turn - last).norm(), 0.004);
    yaw = std::max(yaw, std::abs(turn.z()));
    tilt = std::max(tilt, turn.head<2>().norm());
    last = turn;
  }
  EXPECT_NEAR(yaw, params.yaw, 1e-3);
  EXPECT_NEAR(tilt, params.tilt, 1e-9);
  EXPECT_EQ(last.norm(), 0);
}

class Stall : public testing::Test {
 protected:
  void Push(double force, double height, int num_ticks) {
    for (int i = 0; i < num_ticks; ++i) {
      detector_.Step(force, 15, height, kDt);
    }
  }

  StallDetector detector_{{}, kHeight};
};

TEST_F(Stall, IsKnownWhenAPushedPartDoesNotAdvanceForAWhile) {
  Push(12, kHeight, 30);
  EXPECT_TRUE(detector_.is_stalling());
  EXPECT_FALSE(detector_.is_stalled());
  Push(12, kHeight - 0.0002, 10);
  EXPECT_TRUE(detector_.is_stalled());
}

TEST_F(Stall, IsNoneWhileNothingResists) {
  Push(8, kHeight, 100);
  EXPECT_FALSE(detector_.is_stalling());
}

TEST_F(Stall, EndsWithAnAdvanceHoweverSmall) {
  Push(12, kHeight, 100);
  Push(12, kHeight - 0.0004, 1);
  EXPECT_FALSE(detector_.is_stalling());
  Push(12, kHeight - 0.0004, 39);
  EXPECT_TRUE(detector_.is_stalled());
}

TEST_F(Stall, IsForgottenOnRequest) {
  Push(12, kHeight, 100);
  detector_.Reset();
  EXPECT_FALSE(detector_.is_stalling());
}

}  // namespace
}  // namespace cell
