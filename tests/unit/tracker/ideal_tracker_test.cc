#include "services/tracker/ideal_tracker.h"

#include <gtest/gtest.h>

#include <random>

#include "common/geometry/box_surface.h"
#include "common/geometry/convex_solid.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace tracker;
namespace {

using Eigen::Vector3d;

TEST(BoxSurface, EveryPointOfTheSurfaceHasASampleNearby) {
  const Vector3d half(0.04, 0.025, 0.015);
  const double spacing = 0.008;
  const auto points = SampleBoxSurface(half, spacing);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 3000; ++i) {
    Vector3d p(unit(random), unit(random), unit(random));
    p[i % 3] = i % 2 ? 1 : -1;
    p = p.cwiseProduct(half);
    double nearest = 1;
    for (const Vector3d& q : points)
      nearest = std::min(nearest, (p - q).norm());
    EXPECT_LE(nearest, spacing / std::sqrt(2.0) + 1e-12);
  }
}

TEST(BoxSurface, HasItsCornersAndNoPointTwice) {
  const Vector3d half(0.006, 0.009, 0.04);
  auto points = SampleBoxSurface(half, 0.008);
  for (const double x : {-1., 1.}) {
    for (const double y : {-1., 1.}) {
      for (const double z : {-1., 1.}) {
        const Vector3d corner = half.cwiseProduct(Vector3d(x, y, z));
        EXPECT_TRUE(std::any_of(
            points.begin(), points.end(),
            [&](const Vector3d& p) { return (p - corner).norm() < 1e-12; }));
      }
    }
  }
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR((points[i].cwiseAbs() - half).maxCoeff(), 0, 1e-12);
    for (size_t j = 0; j < i; ++j) {
      EXPECT_GT((points[i] - points[j]).norm(), 1e-6);
    }
  }
  EXPECT_THROW(SampleBoxSurface(half, 0), std::invalid_argument);
}

class IdealTrackerTest : public testing::Test {
 protected:
  TruthPoses Truth() {
    TruthPoses truth{96'000, {}};
    for (const Track& track : stage_.AllTracked().tracks) {
      truth.poses[track.name] = track.X_WO;
    }
    for (const char* body : {"palm", "thumb", "fingers"}) {
      truth.poses[std::string("hand_right.") + body] =
          Eigen::Isometry3d(Eigen::Translation3d(1, 2, 3));
    }
    return truth;
  }

  ShippedTask task_;
  Stage stage_{task_};
  IdealTracker tracker_{task_.scene_objects, task_.layout, {}};
};

TEST_F(IdealTrackerTest, TracksPartsAtTheirTruePoses) {
  const Tracks tracks = tracker_.Update(Truth());
  EXPECT_EQ(tracks.utime, 96'000);
  for (const std::string& part : task_.scene_objects.parts()) {
    const Track* track = tracks.Find(part);
    ASSERT_NE(track, nullptr) << part;
    EXPECT_TRUE(track->X_WO.isApprox(stage_.PoseOf(part)));
    EXPECT_EQ(track->state, Track::State::kTracked);
    EXPECT_EQ(track->confidence, 1);
    EXPECT_TRUE(track->points.empty());
  }
}

TEST_F(IdealTrackerTest, AHandIsPointsOnTheSurfacesOfItsBodies) {
  const Track* hand = nullptr;
  const Tracks tracks = tracker_.Update(Truth());
  hand = tracks.Find("hand_right");
  ASSERT_NE(hand, nullptr);
  EXPECT_GT(hand->points.size(), 100u);
  EXPECT_LT((hand->X_WO.translation() - Vector3d(1, 2, 3)).norm(), 1e-9);
  EXPECT_TRUE(hand->X_WO.linear().isIdentity());
}

TEST_F(IdealTrackerTest, WhatIsNotInTheTruthHasNoTrack) {
  TruthPoses truth = Truth();
  truth.poses.erase("head");
  truth.poses.erase("hand_right.thumb");
  const Tracks tracks = tracker_.Update(truth);
  EXPECT_EQ(tracks.Find("head"), nullptr);
  EXPECT_EQ(tracks.Find("hand_right"), nullptr);
  EXPECT_EQ(tracks.Find("hand_left"), nullptr);
}

TEST_F(IdealTrackerTest, UnknownBodiesHaveNoTracks) {
  TruthPoses truth = Truth();
  const size_t num_tracks = tracker_.Update(truth).tracks.size();
  truth.poses["pedestal"] = truth.poses["table"] =
      Eigen::Isometry3d::Identity();
  EXPECT_EQ(tracker_.Update(truth).tracks.size(), num_tracks);
}

}  // namespace
}  // namespace cell
