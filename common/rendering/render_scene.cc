#include "common/rendering/render_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

#include "common/rendering/posed_scene.h"

namespace cell {
namespace {

// One thread and no more precision lost than need be: the same image always.
constexpr char kDeviceConfig[] = "threads=1,set_affinity=0";

ScenePtr SceneOf(const RenderBody& body, RTCDevice device) {
  ScenePtr scene(rtcNewScene(device));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
      body.vertices.size()));
  for (const Eigen::Vector3f& vertex : body.vertices) {
    vertices = std::copy(vertex.begin(), vertex.end(), vertices);
  }
  auto* indices = static_cast<uint32_t*>(
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(uint32_t), body.triangles.size()));
  for (const auto& triangle : body.triangles) {
    indices = std::copy(triangle.begin(), triangle.end(), indices);
  }
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(scene.get(), mesh);
  rtcReleaseGeometry(mesh);
  rtcCommitScene(scene.get());
  return scene;
}

void Check(const std::vector<RenderBody>& bodies) {
  std::set<std::string> names;
  for (const RenderBody& body : bodies) {
    if (!names.insert(body.name).second) {
      throw std::invalid_argument("two bodies are named " + body.name);
    }
    if (body.triangles.empty()) {
      throw std::invalid_argument("the body " + body.name + " has no shape");
    }
    for (const auto& triangle : body.triangles) {
      for (const uint32_t index : triangle) {
        if (index >= body.vertices.size()) {
          throw std::invalid_argument(
              fmt::format("the body {} has no vertex {}", body.name, index));
        }
      }
    }
  }
}

}  // namespace

RenderScene::RenderScene(std::vector<RenderBody> bodies)
    : bodies_(std::move(bodies)), tracer_(std::make_shared<Tracer>()) {
  Check(bodies_);
  tracer_->device.reset(rtcNewDevice(kDeviceConfig));
  if (!tracer_->device) {
    throw std::runtime_error(fmt::format("Embree returned no device: error {}",
                                         rtcGetDeviceError(nullptr)));
  }
  for (const RenderBody& body : bodies_) {
    tracer_->bodies.push_back(SceneOf(body, tracer_->device.get()));
  }
}

RenderScene::~RenderScene() = default;

std::shared_ptr<const RenderScene::Posed> RenderScene::Pose(
    const std::map<std::string, Eigen::Isometry3d>& X_WO,
    const Eigen::Isometry3d& X_WC) const {
  auto posed = std::make_shared<Posed>();
  posed->tracer = tracer_;
  const RTCDevice device = tracer_->device.get();
  posed->scene.reset(rtcNewScene(device));
  rtcSetSceneFlags(posed->scene.get(), RTC_SCENE_FLAG_ROBUST);
  posed->X_CO.assign(bodies_.size(), Eigen::Isometry3f::Identity());
  for (size_t i = 0; i < bodies_.size(); ++i) {
    const auto given = X_WO.find(bodies_[i].name);
    if (given == X_WO.end() && !bodies_[i].X_WO) continue;
    const Eigen::Isometry3d X_CO =
        X_WC.inverse() *
        (given == X_WO.end() ? *bodies_[i].X_WO : given->second);
    posed->X_CO[i] = X_CO.cast<float>();
    const RTCGeometry instance =
        rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, tracer_->bodies[i].get());
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                            posed->X_CO[i].data());
    rtcCommitGeometry(instance);
    rtcAttachGeometryByID(posed->scene.get(), instance,
                          static_cast<unsigned>(i));
    rtcReleaseGeometry(instance);
  }
  rtcCommitScene(posed->scene.get());
  return posed;
}

}  // namespace cell
