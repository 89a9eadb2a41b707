#include "services/cell/pictures/scene_picture.h"

#include <cmath>
#include <numbers>

#include "common/geometry/pose.h"
#include "common/imaging/camera.h"
#include "common/imaging/png_file.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "common/rendering/cell_bodies.h"
#include "common/rendering/renderer.h"
#include "common/task/task.h"

namespace cell::cli {
namespace {

Camera CameraAt(const Viewpoint& view) {
  const double azimuth = view.azimuth_deg * std::numbers::pi / 180;
  const double elevation = view.elevation_deg * std::numbers::pi / 180;
  const Eigen::Vector3d p_WT(view.target[0], view.target[1], view.target[2]);
  const Eigen::Vector3d direction(std::cos(elevation) * std::cos(azimuth),
                                  std::cos(elevation) * std::sin(azimuth),
                                  std::sin(elevation));
  constexpr double kHorizontalViewRad = 50 * std::numbers::pi / 180;
  return CameraLookingAt(p_WT + view.distance * direction, p_WT, view.width,
                         view.height, kHorizontalViewRad);
}

}  // namespace

std::map<std::string, int> DrawScene(const Deployment& deployment,
                                     const truth_poses_t& poses,
                                     const Viewpoint& viewpoint,
                                     const std::filesystem::path& path) {
  const Task task = LoadTask(deployment);
  const RenderScene scene(BodiesOf(task.parts, task.layout));
  std::map<std::string, Eigen::Isometry3d> X_WO;
  for (const body_pose_t& body : poses.bodies) {
    if (const auto X_WB = PoseFromMessage(body.pose_world_body)) {
      X_WO[body.name] = *X_WB;
    }
  }
  RenderParams params;
  params.samples_per_side = viewpoint.is_of_ids ? 1 : 2;
  const RenderImage image = Render(scene, X_WO, CameraAt(viewpoint), params);
  WritePng(path, viewpoint.is_of_ids ? image.IdPicture() : image.colour);
  std::map<std::string, int> num_pixels;
  for (const auto& [id, num] : image.NumPixels()) {
    if (id < 0) continue;
    num_pixels[scene.bodies()[static_cast<size_t>(id)].name] = num;
  }
  return num_pixels;
}

}  // namespace cell::cli
