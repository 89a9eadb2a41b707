// Pictures that show the whole of what they are of, in colours that differ.
#include "common/rendering/framing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

#include "common/rendering/id_colours.h"

namespace cell {
namespace {

std::vector<Eigen::Vector3d> RandomPoints(std::mt19937_64& random) {
  std::uniform_real_distribution<double> coordinate(-2, 2);
  std::vector<Eigen::Vector3d> points(20);
  for (Eigen::Vector3d& p : points) {
    p = {coordinate(random), coordinate(random), coordinate(random)};
  }
  return points;
}

TEST(Framing, HoldsAllPointsAndTouchesTheMargin) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> azimuth(-3, 3), elevation(0.1, 1.4);
  for (int i = 0; i < 100; ++i) {
    const PictureShape shape{.azimuth_rad = azimuth(random),
                             .elevation_rad = elevation(random)};
    const auto points = RandomPoints(random);
    const Camera camera = CameraThatFrames(points, shape);
    double least = 1;  // free part of the picture
    for (const Eigen::Vector3d& p_W : points) {
      const Eigen::Vector3d p_C = camera.X_WC.inverse() * p_W;
      ASSERT_GT(p_C.z(), 0);
      const double u =
          (camera.fx * p_C.x() / p_C.z() + camera.cx + 0.5) / camera.width;
      const double v =
          (camera.fy * p_C.y() / p_C.z() + camera.cy + 0.5) / camera.height;
      least = std::min({least, u, v, 1 - u, 1 - v});
    }
    EXPECT_NEAR(least, shape.margin, 1e-6) << i;
  }
}

TEST(Framing, OfNothingIsAnError) {
  EXPECT_THROW(CameraThatFrames({}, {.elevation_rad = 1}),
               std::invalid_argument);
}

TEST(DistinctColours, DifferAtAGlanceForEveryBodyOfACell) {
  constexpr size_t kNumBodies = 50;
  const auto colours = DistinctColours(kNumBodies);
  ASSERT_EQ(colours.size(), kNumBodies);
  for (size_t i = 0; i < colours.size(); ++i) {
    EXPECT_GT(ColourDifference(colours[i], {0, 0, 0}), 20) << i;
    for (size_t j = 0; j < i; ++j) {
      EXPECT_GT(ColourDifference(colours[i], colours[j]), 20) << i << " " << j;
    }
  }
}

TEST(DistinctColours, AreTheSameForAnyNumberAndRepeatWhenAllAreUsed) {
  const auto few = DistinctColours(10);
  const auto many = DistinctColours(2000);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  EXPECT_EQ(many.size(), 2000u);
}

}  // namespace
}  // namespace cell
