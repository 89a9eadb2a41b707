// What a frame of a camera set costs: its rays alone (Embree), the picture made
// of them, its encoding, beside PNG. Run while the arms work.
#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>
#include <lodepng.h>

#include <limits>

#include "common/bus/sim_bus.h"
#include "common/imaging/colour_codec.h"
#include "common/imaging/depth_codec.h"
#include "common/rendering/cell_bodies.h"
#include "common/rendering/posed_scene.h"
#include "common/rendering/renderer.h"
#include "services/camera_set/rendered_view.h"
#include "services/cell/running/service_registry.h"

namespace cell {

using namespace camera_set;

using namespace cli;
namespace {

// The cell at one time in an episode of the arms.
struct RenderedScene {
  RenderedScene() {
    const Roster roster = Roster::FromConfig(deployment.ForService("roster"));
    SimBus bus(roster, AllServices(deployment, "execution", 3));
    constexpr int32_t kTick = 1000;
    while (bus.Step() && bus.last_tick().header.tick < kTick) {
      for (const Message& message : bus.last_messages()) {
        truth_poses_t poses{};
        const int size = static_cast<int>(message.bytes->size());
        if (message.channel == "TRUTH_POSES" &&
            poses.decode(message.bytes->data(), 0, size) == size) {
          truth = *TruthFromMessage(poses);
        }
      }
    }
    for (const auto& X_WC : layout.cameras->Poses()) {
      views.push_back(
          CameraWithView(X_WC, 640, 480, layout.cameras->view_angles));
    }
  }

  Deployment deployment{CELL_SOURCE_DIR "/deploy/config",
                        CELL_SOURCE_DIR "/deploy/tasks/cranfield"};
  PartTable parts = PartTable::FromConfig(deployment.OfTask("parts.yaml"));
  CellLayout layout = CellLayout::FromConfig(deployment.OfTask("cell.yaml"));
  RenderScene scene{BodiesOf(parts, layout)};
  TruthPoses truth;
  std::vector<Camera> views;
};

const RenderedScene& TheScene() {
  static const RenderedScene scene;
  return scene;
}

const Camera& ViewOf(const benchmark::State& state) {
  return TheScene().views[static_cast<size_t>(state.range(0)) - 1];
}

RgbdFrame FrameOf(const benchmark::State& state) {
  RenderedView::Params params;
  params.view = ViewOf(state);
  params.has_shadows = false;
  const RenderedScene& scene = TheScene();
  return RenderedView(BodiesOf(scene.parts, scene.layout), params)
      .Capture(scene.truth);
}

// The baseline: as many rays as there are pixels, and nothing made of them.
void RawRays(benchmark::State& state) {
  const Camera& view = ViewOf(state);
  const auto posed = TheScene().scene.Pose(TheScene().truth.poses, view.X_WC);
  constexpr int kSide = 4;
  for (auto _ : state) {
    for (int y = 0; y < view.height; y += kSide) {
      for (int x = 0; x < view.width; x += kSide) {
        alignas(64) RTCRayHit16 rays{};
        alignas(64) int valid[16];
        for (int i = 0; i < 16; ++i) {
          valid[i] = -1;
          rays.ray.dir_x[i] =
              static_cast<float>((x + i % kSide - view.cx) / view.fx);
          const int row = y + i / kSide;
          rays.ray.dir_y[i] = static_cast<float>((row - view.cy) / view.fy);
          rays.ray.dir_z[i] = 1;
          rays.ray.tnear[i] = 1e-3F;
          rays.ray.tfar[i] = std::numeric_limits<float>::infinity();
          rays.ray.mask[i] = ~0U;
          rays.hit.geomID[i] = rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        rtcIntersect16(valid, posed->scene.get(), &context, &rays);
        benchmark::DoNotOptimize(rays.ray.tfar[0]);
      }
    }
  }
}
BENCHMARK(RawRays)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);

void RenderPicture(benchmark::State& state) {
  RenderParams params;
  params.has_shadows = state.range(1) != 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(Render(TheScene().scene, TheScene().truth.poses,
                                    ViewOf(state), params));
  }
}
BENCHMARK(RenderPicture)
    ->ArgNames({"set", "shadows"})
    ->ArgsProduct({{1, 2, 3}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

void WholeFrame(benchmark::State& state) {
  RenderedView::Params params;
  params.view = ViewOf(state);
  params.has_shadows = false;
  const RenderedScene& scene = TheScene();
  const RenderedView view(BodiesOf(scene.parts, scene.layout), params);
  int size = 0;
  for (auto _ : state) {
    const auto message = FrameToMessage(view.Capture(scene.truth), 150'000, 90);
    size = message ? message->getEncodedSize() : 0;
  }
  state.counters["bytes"] = size;
}
BENCHMARK(WholeFrame)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);

void Depth(benchmark::State& state) {
  const DepthImage depth = FrameOf(state).depth;
  size_t size = 0;
  for (auto _ : state) size = EncodeDepth(depth).size();
  state.counters["bytes"] = static_cast<double>(size);
}
BENCHMARK(Depth)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);

void DepthBack(benchmark::State& state) {
  const auto bytes = EncodeDepth(FrameOf(state).depth);
  for (auto _ : state) {
    benchmark::DoNotOptimize(DecodeDepth(bytes, 640, 480));
  }
}
BENCHMARK(DepthBack)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);

void DepthAsPng(benchmark::State& state) {
  const DepthImage depth = FrameOf(state).depth;
  std::vector<unsigned char> raw;
  for (const uint16_t count : depth.counts) {
    raw.push_back(static_cast<unsigned char>(count >> 8));
    raw.push_back(static_cast<unsigned char>(count & 0xff));
  }
  size_t size = 0;
  for (auto _ : state) {
    std::vector<unsigned char> bytes;
    lodepng::encode(bytes, raw, 640, 480, LCT_GREY, 16);
    size = bytes.size();
  }
  state.counters["bytes"] = static_cast<double>(size);
}
BENCHMARK(DepthAsPng)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);

void Colour(benchmark::State& state) {
  const RgbImage colour = FrameOf(state).colour;
  size_t size = 0;
  for (auto _ : state) size = EncodeColour(colour, 90).size();
  state.counters["bytes"] = static_cast<double>(size);
}
BENCHMARK(Colour)->DenseRange(1, 3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cell

BENCHMARK_MAIN();
