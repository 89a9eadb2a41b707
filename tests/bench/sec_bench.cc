// What key frames cost per frame of tracks, by the number of objects, of which
// two are hands at work; and a naive implementation that measures every pair
// exactly however far apart.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <string>

#include "common/config/config.h"
#include "common/geometry/box_surface.h"
#include "services/sec_builder/key_frame_builder.h"

namespace cell {

using namespace sec_builder;
namespace {

constexpr int kNumHands = 2;
constexpr double kPitch = 0.06;  // [m] of the grid that the parts stand on
constexpr int64_t kFrame = 96'000;

/// Boxes of 40 mm with a notch, in rows; each hand is about to take one.
struct Workbench {
  explicit Workbench(int num_objects)
      : num_parts(num_objects - kNumHands),
        parts(PartTable::FromConfig(Config::Parse(PartsYaml(), "parts.yaml"))),
        scene_objects(parts, {"hand_a", "hand_b"}) {
    const int num_columns =
        static_cast<int>(std::ceil(std::sqrt(1.0 * num_parts)));
    for (const std::string& name : scene_objects.names()) {
      if (!scene_objects.IsPart(name)) continue;
      const int i = std::stoi(name.substr(1));
      Track track{name, Track::State::kTracked, 1, {}, {}};
      track.X_WO = Eigen::Isometry3d(Eigen::Translation3d(
          kPitch * (i % num_columns), kPitch * (i / num_columns), 0.02));
      tracks.tracks.push_back(track);
    }
    AddHand("hand_a", {0, 0, 0.05});
    AddHand("hand_b", {kPitch, 0, 0.06});
  }

  std::string PartsYaml() const {
    std::string text = "contacts: []\nparts:\n";
    for (int i = 0; i < num_parts; ++i) {
      text += fmt::format(
          "  p{}: {{type: t, symmetry_order: 1, density: 1000, colour: [1, 1, "
          "1], pieces: [{{kind: box, center: [0, 0, 0], size: [40, 40, 40]}}, "
          "{{kind: box, center: [0, 0, 25], size: [20, 20, 10]}}]}}\n",
          i);
    }
    return text;
  }

  void AddHand(const std::string& name, const Eigen::Vector3d& p_WG) {
    Track hand{name, Track::State::kTracked, 1, {}, {}};
    hand.X_WO = Eigen::Isometry3d(Eigen::Translation3d(p_WG));
    for (const double x : {-0.04, 0.04}) {
      for (const auto& p : SampleBoxSurface({0.006, 0.009, 0.04}, 0.008)) {
        hand.points.push_back(p_WG + p + Eigen::Vector3d(x, 0, 0.04));
      }
    }
    for (const auto& p : SampleBoxSurface({0.04, 0.025, 0.015}, 0.008)) {
      hand.points.push_back(p_WG + p + Eigen::Vector3d(0, 0, 0.09));
    }
    tracks.tracks.push_back(hand);
    std::ranges::sort(tracks.tracks, {}, &Track::name);
  }

  KeyFrameBuilder::Params Params(double pose_noise) const {
    KeyFrameBuilder::Params params{scene_objects, parts, {}, {}, {}};
    params.smoother.position_sd = pose_noise;
    return params;
  }

  int num_parts;
  PartTable parts;
  SceneObjects scene_objects;
  Tracks tracks;
};

void BuildFrames(benchmark::State& state, double pose_noise) {
  Workbench bench(static_cast<int>(state.range(0)));
  KeyFrameBuilder builder(bench.Params(pose_noise));
  for (auto _ : state) {
    bench.tracks.utime += kFrame;
    benchmark::DoNotOptimize(builder.Update(bench.tracks));
  }
}

void KeyFrames(benchmark::State& state) {
  BuildFrames(state, 0);
}
BENCHMARK(KeyFrames)->DenseRange(5, 50, 9)->Unit(benchmark::kMicrosecond);

void KeyFramesOfNoisyPoses(benchmark::State& state) {
  BuildFrames(state, 0.002);
}
BENCHMARK(KeyFramesOfNoisyPoses)
    ->DenseRange(5, 50, 9)
    ->Unit(benchmark::kMicrosecond);

void NaiveKeyFrames(benchmark::State& state) {
  Workbench bench(static_cast<int>(state.range(0)));
  KeyFrameBuilder::Params params = bench.Params(0);
  params.proximity = {0, 10};
  KeyFrameBuilder builder(params);
  for (auto _ : state) {
    bench.tracks.utime += kFrame;
    benchmark::DoNotOptimize(builder.Update(bench.tracks));
  }
}
BENCHMARK(NaiveKeyFrames)->DenseRange(5, 50, 9)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cell

BENCHMARK_MAIN();
