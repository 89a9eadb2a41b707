#include "common/rendering/renderer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "common/rendering/bands.h"
#include "common/rendering/posed_scene.h"

namespace cell {
namespace {

using Eigen::Vector3f;

// Rays of a packet: a square of pixels, since their rays meet the same bodies.
constexpr int kSide = 4;
constexpr int kWidth = kSide * kSide;
// Rows that a thread takes at a time: whole packets, the same for any number.
constexpr int kBand = 4 * kSide;
constexpr float kNear = 1e-3F;
constexpr float kShadowOffset = 1e-4F;  // [m] off the surface
constexpr float kAmbient = 0.30F;

struct Light {
  Vector3f towards_C;
  float power;
};

/// What a sample sees.
struct Sample {
  int32_t body = RenderImage::kNobody;
  float depth = 0;
  Vector3f colour = Vector3f::Zero();  // linear
};

using Samples = std::array<Sample, kWidth>;

/// From the camera through the square with its upper left at (x, y) [px], row
/// by row.
RTCRayHit16 RaysThrough(const Camera& camera, double x, double y) {
  RTCRayHit16 rays;
  for (int i = 0; i < kWidth; ++i) {
    rays.ray.org_x[i] = rays.ray.org_y[i] = rays.ray.org_z[i] = 0;
    rays.ray.dir_x[i] =
        static_cast<float>((x + i % kSide - camera.cx) / camera.fx);
    const int row = i / kSide;
    rays.ray.dir_y[i] = static_cast<float>((y + row - camera.cy) / camera.fy);
    rays.ray.dir_z[i] = 1;  // so that a ray's parameter is the depth
    rays.ray.tnear[i] = kNear;
    rays.ray.tfar[i] = std::numeric_limits<float>::infinity();
    rays.ray.time[i] = 0;
    rays.ray.mask[i] = ~0U;
    rays.ray.id[i] = rays.ray.flags[i] = 0;
    rays.hit.geomID[i] = rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  return rays;
}

class PacketRenderer {
 public:
  PacketRenderer(const RenderScene& scene, const RenderScene::Posed& posed,
                 const Camera& camera, const RenderParams& params)
      : posed_(posed),
        camera_(camera),
        params_(params),
        background_(ToVector(params.background)) {
    for (const RenderBody& body : scene.bodies()) {
      colours_.push_back(ToVector(body.colour));
    }
    const Eigen::Matrix3d R_CW = camera.X_WC.linear().transpose();
    const auto add = [&](const Eigen::Vector3d& towards_W, float power) {
      lights_.push_back({(R_CW * towards_W.normalized()).cast<float>(), power});
    };
    add({-0.35, -0.45, 1.0}, 0.62F);  // the lamp above the person's shoulder
    add({0.80, 0.35, 0.45}, 0.25F);   // the window on the other side
  }

  /// Samples of the square with its upper left at (x, y): its first columns and
  /// rows.
  Samples Look(double x, double y, int num_columns, int num_rows) const {
    alignas(64) int valid[kWidth];
    for (int i = 0; i < kWidth; ++i) {
      valid[i] = i % kSide < num_columns && i / kSide < num_rows ? -1 : 0;
    }
    alignas(64) RTCRayHit16 rays = RaysThrough(camera_, x, y);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, posed_.scene.get(), &context, &rays);

    Samples samples;
    std::array<Vector3f, kWidth> normals;
    for (int i = 0; i < kWidth; ++i) {
      Sample& sample = samples[Slot(i)];
      if (rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) valid[i] = 0;
      if (valid[i] == 0) {
        sample.colour = background_;
        continue;
      }
      sample.body = static_cast<int32_t>(rays.hit.instID[0][i]);
      sample.depth = rays.ray.tfar[i];
      normals[Slot(i)] = NormalOf(rays, i, sample.body);
    }
    Shade(rays, valid, normals, samples);
    return samples;
  }

 private:
  static size_t Slot(int i) { return static_cast<size_t>(i); }
  static Vector3f ToVector(const std::array<double, 3>& colour) {
    return Eigen::Vector3d(colour[0], colour[1], colour[2]).cast<float>();
  }

  /// Unit normal in C towards the camera.
  Vector3f NormalOf(const RTCRayHit16& rays, int i, int32_t body) const {
    const Vector3f normal_O(rays.hit.Ng_x[i], rays.hit.Ng_y[i],
                            rays.hit.Ng_z[i]);
    const Vector3f normal =
        (posed_.X_CO[static_cast<size_t>(body)].linear() * normal_O)
            .normalized();
    const Vector3f ahead(rays.ray.dir_x[i], rays.ray.dir_y[i],
                         rays.ray.dir_z[i]);
    return normal.dot(ahead) > 0 ? Vector3f(-normal) : normal;
  }

  void Shade(const RTCRayHit16& rays, const int* valid,
             const std::array<Vector3f, kWidth>& normals,
             Samples& samples) const {
    std::array<float, kWidth> brightness;
    brightness.fill(kAmbient);
    for (const Light& light : lights_) {
      const auto lit = IsLit(rays, valid, normals, samples, light);
      for (int i = 0; i < kWidth; ++i) {
        if (valid[i] == 0 || !lit[Slot(i)]) continue;
        const float cosine = normals[Slot(i)].dot(light.towards_C);
        brightness[Slot(i)] += light.power * std::max(0.F, cosine);
      }
    }
    for (int i = 0; i < kWidth; ++i) {
      if (valid[i] == 0) continue;
      Sample& sample = samples[Slot(i)];
      sample.colour =
          colours_[static_cast<size_t>(sample.body)] * brightness[Slot(i)];
    }
  }

  std::array<bool, kWidth> IsLit(const RTCRayHit16& rays, const int* valid,
                                 const std::array<Vector3f, kWidth>& normals,
                                 const Samples& samples,
                                 const Light& light) const {
    std::array<bool, kWidth> is_lit;
    is_lit.fill(true);
    if (!params_.has_shadows) return is_lit;
    alignas(64) RTCRay16 shadow = rays.ray;
    for (int i = 0; i < kWidth; ++i) {
      const float depth = samples[Slot(i)].depth;
      const Vector3f start =
          depth * Vector3f(rays.ray.dir_x[i], rays.ray.dir_y[i], 1) +
          (valid[i] == 0 ? Vector3f::Zero().eval()
                         : Vector3f(kShadowOffset * normals[Slot(i)]));
      shadow.org_x[i] = start.x();
      shadow.org_y[i] = start.y();
      shadow.org_z[i] = start.z();
      shadow.dir_x[i] = light.towards_C.x();
      shadow.dir_y[i] = light.towards_C.y();
      shadow.dir_z[i] = light.towards_C.z();
      shadow.tnear[i] = 0;
      shadow.tfar[i] = std::numeric_limits<float>::infinity();
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded16(valid, posed_.scene.get(), &context, &shadow);
    for (int i = 0; i < kWidth; ++i) is_lit[Slot(i)] = shadow.tfar[i] >= 0;
    return is_lit;
  }

  const RenderScene::Posed& posed_;
  const Camera& camera_;
  const RenderParams& params_;
  Vector3f background_;
  std::vector<Vector3f> colours_;  // of the bodies
  std::vector<Light> lights_;
};

/// 8-bit sRGB (as a power of 1/2.2) of linear values, by a table: a power per
/// pixel would cost more than the rays.
class Gamma {
 public:
  Gamma() {
    for (size_t i = 0; i < table_.size(); ++i) {
      const double linear = static_cast<double>(i) / kSteps;
      table_[i] =
          static_cast<uint8_t>(std::lround(255 * std::pow(linear, 1 / 2.2)));
    }
  }
  std::array<uint8_t, 3> Encode(const Vector3f& linear) const {
    std::array<uint8_t, 3> pixel{};
    for (int i = 0; i < 3; ++i) {
      const float step = std::clamp(linear[i], 0.F, 1.F) * kSteps + 0.5F;
      pixel[static_cast<size_t>(i)] = table_[static_cast<size_t>(step)];
    }
    return pixel;
  }

 private:
  static constexpr int kSteps = 8192;
  std::array<uint8_t, kSteps + 1> table_{};
};

RenderImage EmptyImage(const Camera& camera) {
  const size_t size =
      static_cast<size_t>(camera.width) * static_cast<size_t>(camera.height);
  RenderImage image;
  image.colour = {camera.width, camera.height, {}};
  image.colour.pixels.resize(size);
  image.depth.resize(size);
  image.body_id.resize(size, RenderImage::kNobody);
  return image;
}

/// The rows first <= row < last; calls for other rows may run at the same time.
void RenderRows(const PacketRenderer& renderer, const Camera& camera, int side,
                int first, int last, RenderImage& image) {
  static const Gamma gamma;
  for (int top = first; top < last; top += kSide) {
    const int num_rows = std::min(kSide, last - top);
    for (int left = 0; left < camera.width; left += kSide) {
      const int num_columns = std::min(kSide, camera.width - left);
      const Samples centres = renderer.Look(left, top, num_columns, num_rows);
      std::array<Vector3f, kWidth> colours;
      colours.fill(Vector3f::Zero());
      for (int k = 0; k < side * side; ++k) {
        const double x = left + (k % side + 0.5) / side - 0.5;
        const int below = k / side;
        const double y = top + (below + 0.5) / side - 0.5;
        const Samples samples =
            side == 1 ? centres : renderer.Look(x, y, num_columns, num_rows);
        for (size_t i = 0; i < kWidth; ++i) colours[i] += samples[i].colour;
      }
      for (int i = 0; i < kSide * num_rows; ++i) {
        if (i % kSide >= num_columns) continue;
        const size_t index = image.Index(left + i % kSide, top + i / kSide);
        const auto slot = static_cast<size_t>(i);
        image.colour.pixels[index] =
            gamma.Encode(colours[slot] / static_cast<float>(side * side));
        image.depth[index] = centres[slot].depth;
        image.body_id[index] = centres[slot].body;
      }
    }
  }
}

}  // namespace

RenderImage Render(const RenderScene& scene,
                   const std::map<std::string, Eigen::Isometry3d>& X_WO,
                   const Camera& camera, const RenderParams& params) {
  RenderImage image = EmptyImage(camera);
  const auto posed = scene.Pose(X_WO, camera.X_WC);
  const PacketRenderer renderer(scene, *posed, camera, params);
  ForEachBand(camera.height, kBand, params.num_threads,
              [&](int first, int last) {
                RenderRows(renderer, camera, params.samples_per_side, first,
                           last, image);
              });
  return image;
}

}  // namespace cell
