// Learning rules from experiences of a robot manipulation domain. Beside it,
// what the learner's caches are for: evaluating the same literals for the same
// experiences with nothing kept.
#include <benchmark/benchmark.h>

#include "common/rules/learning/learner.h"
#include "common/rules/simulation.h"
#include "tests/unit/rules/manipulation_domain.h"
#include "tests/unit/rules/small_world.h"

namespace cell::rules {
namespace {

ExperienceSet Drawn(int number) {
  const NdrRules truth = ParseRules(kManipulationRules, "r");
  const auto world =
      std::make_shared<World>(truth.symbols, ObjectsFrom(kManipulationObjects));
  const WorldState initial = ParseState(kManipulationState, "d", 1, *world);
  return DrawExperiences(truth, world, initial, number, 30, 1);
}

void Learning(benchmark::State& state) {
  const ExperienceSet set = Drawn(static_cast<int>(state.range(0)));
  double score = 0;
  for (auto _ : state) {
    Learner learner(set.world, {});
    for (const Experience& e : set.experiences) learner.Add(e);
    learner.Learn();
    score = learner.Score();
  }
  state.counters["score"] = score;
}

void AddingOneExperience(benchmark::State& state) {
  const ExperienceSet set = Drawn(static_cast<int>(state.range(0)) + 1);
  for (auto _ : state) {
    state.PauseTiming();
    Learner learner(set.world, {});
    for (size_t i = 0; i + 1 < set.experiences.size(); ++i) {
      learner.Add(set.experiences[i]);
    }
    learner.Learn();
    state.ResumeTiming();
    learner.Add(set.experiences.back());
    learner.Learn();
  }
}

/// All literals over the arguments, in all experiences of each action.
template <bool kIsCached>
void CoverageOfAllLiterals(benchmark::State& state) {
  const ExperienceSet set = Drawn(static_cast<int>(state.range(0)));
  for (const int action : set.world->symbols().Actions()) {
    RuleSearch search(set.world, action, {});
    for (const Experience& e : set.experiences) {
      if (e.act.action == action) search.Add(e);
    }
    const std::vector<int> literals = search.Literals({});
    FeatureTable& table = search.table();
    for (const int number : literals) table.Before(number);
    for (auto _ : state) {
      int num_held = 0;
      for (const int number : literals) {
        if constexpr (kIsCached) {
          num_held += table.Before(number).Count();
        } else {
          for (int e = 0; e < table.size(); ++e) {
            num_held += table.HoldsBefore(table.feature(number), e, -1);
          }
        }
      }
      benchmark::DoNotOptimize(num_held);
    }
    break;
  }
}

BENCHMARK(Learning)->Arg(29)->Arg(100)->Arg(300)->Arg(1000)->Unit(
    benchmark::kMillisecond);
BENCHMARK(AddingOneExperience)
    ->Arg(29)
    ->Arg(300)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(CoverageOfAllLiterals<true>)->Arg(300)->Unit(benchmark::kMicrosecond);
BENCHMARK(CoverageOfAllLiterals<false>)
    ->Arg(300)
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace cell::rules

BENCHMARK_MAIN();
