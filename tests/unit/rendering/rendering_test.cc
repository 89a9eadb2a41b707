#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "common/rendering/cell_bodies.h"
#include "common/rendering/renderer.h"

namespace cell {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double kView = 57 * std::numbers::pi / 180;

std::vector<RenderBody> TableAndBox() {
  std::vector<RenderBody> bodies = {
      PlaneBody("table", 2, {0.5, 0.5, 0.5}),
      BoxBody("box", {0.1, 0.15, 0.2}, {0.9, 0.2, 0.2}),
      BoxBody("other", {0.05, 0.05, 0.05}, {0.2, 0.9, 0.2})};
  bodies[0].X_WO = Isometry3d::Identity();
  return bodies;
}

std::map<std::string, Isometry3d> BoxOnTable() {
  return {{"box", Isometry3d(Eigen::Translation3d(0, 0, 0.2))}};
}

TEST(Rendering, TheBoxIsAtTheCentreAndTheTableAround) {
  const RenderScene scene(TableAndBox());
  const Camera camera =
      CameraLookingAt({0.5, -1, 1}, {0, 0, 0.2}, 641, 481, kView);
  const RenderImage image = Render(scene, BoxOnTable(), camera);
  EXPECT_EQ(image.body_id[image.Index(320, 240)], 1);
  EXPECT_EQ(image.body_id[image.Index(5, 475)], 0);
  const auto num_pixels = image.NumPixels();
  EXPECT_FALSE(num_pixels.contains(2)) << "a body without a pose is not there";
  EXPECT_GT(num_pixels.at(1), 1000);
}

// The ray of each pixel, met with the plane z = 0 and with the box's slabs.
TEST(Rendering, DepthIsThatOfTheAnalyticScene) {
  const RenderScene scene(TableAndBox());
  const Camera camera =
      CameraLookingAt({0.5, -1, 1}, {0, 0, 0.2}, 320, 240, kView);
  const RenderImage image = Render(scene, BoxOnTable(), camera);
  const Vector3d low(-0.1, -0.15, 0);
  const Vector3d high(0.1, 0.15, 0.4);
  int num_checked = 0;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const Vector3d d =
          camera.X_WC.linear() *
          Vector3d((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1);
      const Vector3d o = camera.X_WC.translation();
      const Vector3d a = (low - o).cwiseQuotient(d);
      const Vector3d b = (high - o).cwiseQuotient(d);
      const double enter = a.cwiseMin(b).maxCoeff();
      const double leave = a.cwiseMax(b).minCoeff();
      const size_t index = image.Index(u, v);
      if (std::abs(leave - enter) < 1e-4) continue;  // an edge
      const bool is_box = enter < leave;
      const double expected = is_box ? enter : -o.z() / d.z();
      const Vector3d p = o + expected * d;
      if (!is_box && (d.z() >= 0 || p.cwiseAbs().head<2>().maxCoeff() > 1.99)) {
        continue;
      }
      ASSERT_EQ(image.body_id[index], is_box ? 1 : 0) << u << " " << v;
      ASSERT_NEAR(image.depth[index], expected, 1e-5) << u << " " << v;
      ++num_checked;
    }
  }
  EXPECT_GT(num_checked, 60'000);
}

TEST(Rendering, NumberOfThreadsDoesNotChangeTheImage) {
  const RenderScene scene(TableAndBox());
  const Camera camera =
      CameraLookingAt({0.4, -1, 0.8}, {0, 0, 0.1}, 203, 151, kView);
  RenderParams params;
  params.samples_per_side = 2;
  const RenderImage one = Render(scene, BoxOnTable(), camera, params);
  for (const int num_threads : {0, 2, 5, 64}) {
    params.num_threads = num_threads;
    const RenderImage image = Render(scene, BoxOnTable(), camera, params);
    EXPECT_EQ(image.colour.pixels, one.colour.pixels);
    EXPECT_EQ(image.depth, one.depth);
    EXPECT_EQ(image.body_id, one.body_id);
  }
}

TEST(Rendering, AShadowDarkensTheTable) {
  const RenderScene scene(TableAndBox());
  const Camera camera =
      CameraLookingAt({0.3, -1, 1.5}, {0.15, 0.1, 0}, 320, 240, kView);
  RenderParams without;
  without.has_shadows = false;
  const RenderImage lit = Render(scene, BoxOnTable(), camera, without);
  const RenderImage shaded = Render(scene, BoxOnTable(), camera);
  int num_darker = 0;
  for (size_t i = 0; i < lit.depth.size(); ++i) {
    ASSERT_LE(shaded.colour.pixels[i], lit.colour.pixels[i]);
    num_darker += shaded.colour.pixels[i] < lit.colour.pixels[i];
  }
  EXPECT_GT(num_darker, 500);
  EXPECT_EQ(shaded.depth, lit.depth);
}

TEST(Rendering, AnEmptyViewIsBackgroundWithoutDepth) {
  const RenderScene scene(TableAndBox());
  const Camera camera = CameraLookingAt({0, -1, 1}, {0, -2, 3}, 33, 17, kView);
  const RenderImage image = Render(scene, {}, camera);
  EXPECT_TRUE(image.NumPixels().empty());
  EXPECT_THAT(image.depth, testing::Each(0.F));
}

TEST(Rendering, RefusesBodiesThatCannotBe) {
  auto duplicates = TableAndBox();
  duplicates[1].name = "other";
  EXPECT_THROW(RenderScene{duplicates}, std::invalid_argument);
  auto empty = TableAndBox();
  empty[2].triangles.clear();
  EXPECT_THROW(RenderScene{empty}, std::invalid_argument);
  auto broken = TableAndBox();
  broken[2].triangles[0][1] = 99;
  EXPECT_THROW(RenderScene{broken}, std::invalid_argument);
}

TEST(Rendering, ACameraLooksWhereItShouldWithUpwardsUp) {
  const Vector3d p_WC(1, -2, 1.5);
  const Vector3d p_WT(0.1, 0.2, 0.3);
  const Camera camera = CameraLookingAt(p_WC, p_WT, 640, 480, kView);
  const Vector3d p_CT = camera.X_WC.inverse() * p_WT;
  EXPECT_LT(p_CT.head<2>().norm(), 1e-12);
  EXPECT_NEAR(p_CT.z(), (p_WT - p_WC).norm(), 1e-12);
  EXPECT_LT((camera.X_WC.inverse() * (p_WT + Vector3d(0, 0, 0.1))).y(), 0);
  EXPECT_NEAR(camera.X_WC.linear().determinant(), 1, 1e-12);
  EXPECT_THROW(CameraLookingAt(p_WT, p_WT + Vector3d(0, 0, 1), 4, 4, kView),
               std::invalid_argument);
}

TEST(CellBodies, EveryPartIsSeenWhenLaidOut) {
  const std::string task = CELL_SOURCE_DIR "/deploy/tasks/cranfield/";
  const PartTable parts =
      PartTable::FromConfig(Config::Load(task + "parts.yaml"));
  const CellLayout layout =
      CellLayout::FromConfig(Config::Load(task + "cell.yaml"));
  const RenderScene scene(BodiesOf(parts, layout));
  std::map<std::string, Isometry3d> X_WO;
  for (size_t i = 0; i < parts.parts().size(); ++i) {
    const double x = 0.35 * (static_cast<double>(i % 4) - 1.5);
    const double y = 0.35 * (static_cast<double>(i / 4) - 1);
    X_WO[parts.parts()[i].name] =
        Eigen::Translation3d(x, y, 0.15) * Isometry3d::Identity();
  }
  const Camera camera =
      CameraLookingAt({0.2, -1.6, 1.4}, {0, 0, 0.1}, 640, 480, kView);
  RenderParams params;
  params.samples_per_side = 2;
  const RenderImage image = Render(scene, X_WO, camera, params);
  const auto num_pixels = image.NumPixels();
  for (size_t i = 0; i < scene.bodies().size(); ++i) {
    const std::string& name = scene.bodies()[i].name;
    if (name.find('.') != std::string::npos) continue;  // a hand's box
    const auto it = num_pixels.find(static_cast<int32_t>(i));
    EXPECT_GE(it == num_pixels.end() ? 0 : it->second, 50) << name;
  }
}

}  // namespace
}  // namespace cell
