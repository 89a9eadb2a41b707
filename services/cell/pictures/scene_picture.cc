#include "services/cell/pictures/scene_picture.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/geometry/degree.h"
#include "common/geometry/pose.h"
#include "common/imaging/png_file.h"
#include "common/layout/cell_layout.h"
#include "common/parts/part_table.h"
#include "common/rendering/cell_bodies.h"
#include "common/rendering/framing.h"
#include "common/rendering/renderer.h"
#include "common/task/task.h"
#include "common/text/nearest.h"
#include "services/cell/pictures/text_drawing.h"

namespace cell::cli {
namespace {

constexpr char kTable[] = "table";

/// Whether the picture is of this body.
bool IsIn(const std::string& focus, const std::string& body,
          const PartTable& parts) {
  if (focus == "cell") return body != kTable;
  if (focus == "parts") return parts.Find(body) != nullptr;
  return body == focus || body.starts_with(focus + ".");
}

/// [m] in W: the corners of what the picture is of. @throws
/// std::invalid_argument if that is not there.
std::vector<Eigen::Vector3d> PointsOf(
    const std::string& focus, const RenderScene& scene, const PartTable& parts,
    const std::map<std::string, Eigen::Isometry3d>& X_WO) {
  std::vector<Eigen::Vector3d> p_W;
  std::vector<std::string> names = {"cell", "parts"};
  for (const RenderBody& body : scene.bodies()) {
    names.push_back(body.name.substr(0, body.name.find('.')));
    if (!IsIn(focus, body.name, parts)) continue;
    const auto it = X_WO.find(body.name);
    if (it == X_WO.end() && !body.X_WO) continue;
    const Eigen::Isometry3d X = it == X_WO.end() ? *body.X_WO : it->second;
    for (const Eigen::Vector3f& p_O : body.vertices) {
      p_W.push_back(X * p_O.cast<double>());
    }
  }
  if (!p_W.empty()) return p_W;
  names.erase(std::unique(names.begin(), names.end()), names.end());
  throw std::invalid_argument("nothing is named '" + focus + "'" +
                              NamesInstead(focus, names));
}

PictureShape ShapeOf(const Viewpoint& view) {
  constexpr double kHorizontalViewRad = 50 * kDegree;
  return {.azimuth_rad = view.azimuth_deg * kDegree,
          .elevation_rad = view.elevation_deg * kDegree,
          .width = view.width,
          .height = view.height,
          .horizontal_view_rad = kHorizontalViewRad};
}

/// Writes the name of each part on the middle of what is seen of it.
void LabelParts(const RenderScene& scene, const PartTable& parts,
                const RenderImage& image, RgbImage* picture) {
  struct Middle {
    int64_t columns = 0, rows = 0, num = 0;
  };
  std::map<int32_t, Middle> middles;
  for (int row = 0; row < picture->height; ++row) {
    for (int column = 0; column < picture->width; ++column) {
      const int32_t id = image.body_id[image.Index(column, row)];
      if (id == RenderImage::kNobody) continue;
      Middle& middle = middles[id];
      middle.columns += column;
      middle.rows += row;
      ++middle.num;
    }
  }
  constexpr int kScale = 2;
  for (const auto& [id, middle] : middles) {
    const std::string& name = scene.bodies()[static_cast<size_t>(id)].name;
    if (parts.Find(name) == nullptr) continue;
    const auto [width, height] = TextSize(name, kScale);
    DrawText(name, static_cast<int>(middle.columns / middle.num) - width / 2,
             static_cast<int>(middle.rows / middle.num) - height / 2, kScale,
             picture);
  }
}

}  // namespace

ScenePicture PictureOf(const Task& task, const truth_poses_t& poses,
                       const Viewpoint& viewpoint) {
  const RenderScene scene(BodiesOf(task.parts, task.layout));
  std::map<std::string, Eigen::Isometry3d> X_WO;
  for (const body_pose_t& body : poses.bodies) {
    if (const auto X_WB = PoseFromMessage(body.pose_world_body)) {
      X_WO[body.name] = *X_WB;
    }
  }
  RenderParams params;
  params.samples_per_side = viewpoint.is_of_ids ? 1 : 2;
  const RenderImage image = Render(
      scene, X_WO,
      CameraThatFrames(PointsOf(viewpoint.focus, scene, task.parts, X_WO),
                       ShapeOf(viewpoint)),
      params);
  ScenePicture picture{viewpoint.is_of_ids ? image.IdPicture() : image.colour,
                       {}};
  if (viewpoint.has_labels) {
    LabelParts(scene, task.parts, image, &picture.image);
  }
  for (const auto& [id, num] : image.NumPixels()) {
    if (id < 0) continue;
    picture.num_pixels[scene.bodies()[static_cast<size_t>(id)].name] = num;
  }
  return picture;
}

std::map<std::string, int> DrawScene(const Deployment& deployment,
                                     const truth_poses_t& poses,
                                     const Viewpoint& viewpoint,
                                     const std::filesystem::path& path) {
  const ScenePicture picture =
      PictureOf(LoadTask(deployment), poses, viewpoint);
  WritePng(path, picture.image);
  return picture.num_pixels;
}

}  // namespace cell::cli
