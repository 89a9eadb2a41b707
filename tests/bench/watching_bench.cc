// What watching costs: proximities of a frame, and what a key frame sets off.
#include <benchmark/benchmark.h>

#include <string>

#include "services/recognizer/recognition.h"
#include "services/sec_builder/key_frame_extractor.h"
#include "services/sec_builder/proximity.h"
#include "services/tracker/ideal_tracker.h"
#include "tests/bench/yardstick.h"
#include "tests/unit/stage_testing.h"

namespace cell {

using namespace recognizer;
using namespace sec_builder;
using namespace tracker;
namespace {

enum Scenery { kBegin, kAssembled, kHandsAtWork };

struct Watched {
  explicit Watched(int scenery) {
    if (scenery != kBegin) stage.SeatAll();
    TruthPoses truth;
    for (const Track& track : stage.AllTracked().tracks) {
      truth.poses[track.name] = track.X_WO;
    }
    double side = -1;
    for (const CellLayout::Hand& hand : task.layout.hands) {
      Eigen::Isometry3d X_WG(Eigen::Translation3d(hand.p_WG_rest));
      if (scenery == kHandsAtWork) {
        X_WG.translation() << 0.05 * side, -0.04, 0.225;
      }
      side = 1;
      AddHand(hand.type, hand.name, X_WG, 0.028, truth);
    }
    tracks = IdealTracker(task.scene_objects, task.layout, {}).Update(truth);
  }

  ShippedTask task;
  Stage stage{task};
  Tracks tracks;
};

void MeasureProximities(benchmark::State& state) {
  const Watched watched(static_cast<int>(state.range(0)));
  const ProximitySensor sensor(watched.task.scene_objects, watched.task.parts,
                               {});
  for (auto _ : state) {
    benchmark::DoNotOptimize(sensor.Measure(watched.tracks));
  }
}
BENCHMARK(MeasureProximities)
    ->Arg(kBegin)
    ->Arg(kAssembled)
    ->Arg(kHandsAtWork)
    ->Unit(benchmark::kMicrosecond);

void UpdateKeyFrameExtractor(benchmark::State& state) {
  Watched watched(kHandsAtWork);
  const Proximities proximities =
      ProximitySensor(watched.task.scene_objects, watched.task.parts, {})
          .Measure(watched.tracks);
  KeyFrameExtractor extractor(watched.task.scene_objects, {});
  for (auto _ : state) {
    watched.tracks.utime += 96'000;
    benchmark::DoNotOptimize(extractor.Update(watched.tracks, proximities));
  }
}
BENCHMARK(UpdateKeyFrameExtractor)->Unit(benchmark::kMicrosecond);

void TracksThroughTheirMessage(benchmark::State& state) {
  const Watched watched(kBegin);
  for (auto _ : state) {
    benchmark::DoNotOptimize(TracksFromMessage(
        TracksToMessage(watched.tracks, watched.task.scene_objects),
        watched.task.scene_objects));
  }
}
BENCHMARK(TracksThroughTheirMessage)->Unit(benchmark::kMicrosecond);

void SenseAllPredicates(benchmark::State& state) {
  Watched watched(static_cast<int>(state.range(0)));
  const auto sensor = watched.task.MakeSensor();
  const Scene scene =
      SceneOf(watched.stage.Frame(), watched.task.scene_objects);
  for (auto _ : state) benchmark::DoNotOptimize(sensor->Sense(scene));
}
BENCHMARK(SenseAllPredicates)
    ->Arg(kBegin)
    ->Arg(kAssembled)
    ->Unit(benchmark::kMicrosecond);

// Two key frames: picked up, and let go.
void RecogniseATouch(benchmark::State& state) {
  Watched watched(kAssembled);
  Recognition recognition(watched.task.scene_objects, watched.task.parts,
                          watched.task.MakeLibrary(), watched.task.MakeSensor(),
                          {});
  watched.stage.Hold("hand_left", "shaft");
  const KeyFrame held = watched.stage.Frame();
  watched.stage.LetGo("hand_left", "shaft");
  const KeyFrame placed = watched.stage.Frame();
  for (auto _ : state) {
    benchmark::DoNotOptimize(recognition.Update(held));
    benchmark::DoNotOptimize(recognition.Update(placed));
  }
}
BENCHMARK(RecogniseATouch)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cell

BENCHMARK_MAIN();
