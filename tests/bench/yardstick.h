#pragma once

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>

namespace cell {

/// The baseline of what has none of its own: a chain of 10,000 poses. Its time
/// depends on the machine and the compiler only.
inline void Yardstick(benchmark::State& state) {
  const Eigen::Isometry3d step(
      Eigen::Translation3d(0.01, 0, 0) *
      Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitZ()));
  for (auto _ : state) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    for (int i = 0; i < 10'000; ++i) pose = pose * step;
    benchmark::DoNotOptimize(pose);
  }
}
BENCHMARK(Yardstick)->Unit(benchmark::kMicrosecond);

}  // namespace cell
