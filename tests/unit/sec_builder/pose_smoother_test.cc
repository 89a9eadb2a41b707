#include "services/sec_builder/pose_smoother.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "common/geometry/pose.h"

namespace cell {

using namespace sec_builder;
namespace {

using Eigen::Vector3d;

constexpr int64_t kCameraPeriod = 96'000;
constexpr double kSd = 0.002;
constexpr int kLag = 6;

Tracks At(int frame, const Vector3d& p_WO) {
  Track track{"a", Track::State::kTracked, 1, {}, {}};
  track.X_WO = Eigen::Isometry3d(Eigen::Translation3d(p_WO));
  return {kCameraPeriod * frame, {track}};
}

// Smoothed positions of a part that a function of the frame moves; frame i is
// element i.
template <class Path>
std::vector<Vector3d> Smoothed(Path path, int num_frames, uint64_t seed,
                               double noise = kSd) {
  PoseSmoother smoother({.position_sd = kSd, .lag_frames = kLag});
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, noise);
  std::vector<Vector3d> positions;
  for (int i = 0; i < num_frames; ++i) {
    const Vector3d error(normal(random), normal(random), normal(random));
    const auto smooth = smoother.Update(At(i, path(i) + error));
    EXPECT_EQ(smooth.has_value(), i >= kLag);
    if (!smooth) continue;
    EXPECT_EQ(smooth->utime, kCameraPeriod * (i - kLag));
    positions.push_back(smooth->tracks[0].X_WO.translation());
  }
  return positions;
}

TEST(PoseSmoother, WithoutNoiseTracksComeOutAtOnceAsTheyAre) {
  PoseSmoother smoother({.position_sd = 0});
  for (int i = 0; i < 3; ++i) {
    const auto tracks = smoother.Update(At(i, {1.0 * i, 0, 0}));
    ASSERT_TRUE(tracks);
    EXPECT_EQ(tracks->utime, kCameraPeriod * i);
    EXPECT_EQ(tracks->tracks[0].X_WO.translation().x(), i);
  }
}

TEST(PoseSmoother, WhatRestsIsAveragedOverItsRest) {
  const auto at_rest = [](int) -> Vector3d {
    return {0.1, 0.2, 0.3};
  };
  double squares = 0;
  int count = 0;
  for (const uint64_t seed : {1, 2, 3, 4, 5}) {
    const auto positions = Smoothed(at_rest, 300, seed);
    for (size_t i = 40; i < positions.size(); ++i) {
      squares += (positions[i] - at_rest(0)).squaredNorm() / 3;
      ++count;
    }
  }
  EXPECT_LT(std::sqrt(squares / count), kSd / 3);
}

// Property: the moment at which it begins to move is not blurred.
TEST(PoseSmoother, AJumpStaysAJump) {
  const auto jump = [](int i) -> Vector3d {
    return {i < 50 ? 0.0 : 0.03, 0, 0};
  };
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const auto positions = Smoothed(jump, 100, seed);
    EXPECT_LT(positions[49].x(), 0.005) << seed;
    EXPECT_GT(positions[50].x(), 0.025) << seed;
  }
}

TEST(PoseSmoother, WhatMovesIsNotHeldBack) {
  const auto move = [](int i) -> Vector3d {
    return {0.01 * i, 0, 0};
  };
  const auto positions = Smoothed(move, 60, 1, 0);
  for (size_t i = 1; i < positions.size(); ++i) {
    EXPECT_NEAR(positions[i].x(), 0.01 * static_cast<double>(i), 1e-9);
  }
}

TEST(PoseSmoother, PointsOfAHandMoveWithItsCentroid) {
  PoseSmoother smoother({.position_sd = kSd, .lag_frames = kLag});
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal(0, kSd);
  double worst = 0;
  for (int i = 0; i < 80; ++i) {
    const Vector3d centre(normal(random), normal(random), normal(random));
    Tracks tracks = At(i, centre);
    tracks.tracks[0].points = {centre + Vector3d(0.1, 0, 0)};
    const auto smooth = smoother.Update(tracks);
    if (i < 40) continue;
    const Track& track = smooth->tracks[0];
    EXPECT_NEAR((track.points[0] - track.X_WO.translation()).norm(), 0.1,
                1e-12);
    worst = std::max(worst, track.X_WO.translation().norm());
  }
  EXPECT_LT(worst, 2 * kSd);
}

TEST(PoseSmoother, AFrameWithoutATrackStaysWithout) {
  PoseSmoother smoother({.position_sd = kSd, .lag_frames = 2});
  std::vector<size_t> num_tracks;
  for (int i = 0; i < 12; ++i) {
    Tracks tracks = At(i, {0, 0, 0});
    if (i == 0 || i == 5) tracks.tracks.clear();
    const auto smooth = smoother.Update(tracks);
    if (smooth) num_tracks.push_back(smooth->tracks.size());
  }
  EXPECT_EQ(num_tracks, (std::vector<size_t>{0, 1, 1, 1, 1, 0, 1, 1, 1, 1}));
}

}  // namespace
}  // namespace cell
