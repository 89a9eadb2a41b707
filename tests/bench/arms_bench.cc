// What an arm's questions cost: may it stand so, and which grasps has it.
#include <benchmark/benchmark.h>

#include <random>

#include "common/arms/path_planner.h"
#include "common/arms/reach.h"
#include "tests/bench/yardstick.h"
#include "tests/unit/stage_testing.h"

namespace cell {
namespace {

struct Cell {
  Cell() {
    Stage stage(task);
    for (const Part& part : task.parts.parts()) {
      scene.PutPart(part.name, stage.PoseOf(part.name));
    }
    // Over the parts, where there is most to look at.
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> x(-0.3, 0.45), y(-0.6, -0.3),
        z(0.06, 0.25);
    while (postures.size() < 256) {
      const Eigen::Isometry3d X_WG(
          Eigen::Translation3d(x(random), y(random), z(random)));
      if (const auto q = TrackPose(arm(), X_WG, arm().home)) {
        postures.push_back({*q, "two_finger_pinch", 0.06});
      }
    }
  }
  const ArmLayout& arm() const { return *task.layout.FindArm("right"); }

  ShippedTask task;
  ArmScene scene{task.parts, task.layout};
  std::vector<ArmPosture> postures;
};

void AskPostures(benchmark::State& state, ArmScene scene,
                 const std::vector<ArmPosture>& postures) {
  size_t i = 0;
  int64_t num_free = 0;
  for (auto _ : state) {
    num_free +=
        scene.WhyBlocked("right", postures[i++ % postures.size()]) ? 0 : 1;
  }
  state.counters["free"] =
      static_cast<double>(num_free) / static_cast<double>(state.iterations());
}

void AskWithEmptyHand(benchmark::State& state) {
  const Cell cell;
  AskPostures(state, cell.scene, cell.postures);
}
BENCHMARK(AskWithEmptyHand)->Unit(benchmark::kMicrosecond);

void AskWithAPart(benchmark::State& state) {
  Cell cell;
  const Part* part = &cell.task.parts.parts().back();
  cell.scene.Hold("right", part->name, part->grasps[0].X_OG.inverse());
  AskPostures(state, cell.scene, cell.postures);
}
BENCHMARK(AskWithAPart)->Unit(benchmark::kMicrosecond);

void FindGrasps(benchmark::State& state) {
  const Cell cell;
  const Reach reach(cell.scene, "right");
  for (auto _ : state) {
    benchmark::DoNotOptimize(reach.Grasps("shaft", cell.arm().home));
  }
}
BENCHMARK(FindGrasps)->Unit(benchmark::kMillisecond);

void SolveTheInverse(benchmark::State& state) {
  const Cell cell;
  const Eigen::Isometry3d X_BF = cell.arm().model->FlangePose(cell.arm().home);
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        cell.arm().model->SolveInverse(X_BF, cell.arm().home));
  }
}
BENCHMARK(SolveTheInverse)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cell

BENCHMARK_MAIN();
