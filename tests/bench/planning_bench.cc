// Planning with bounds beside plain value iteration over all reachable states,
// on a family of problems that grows. Example:
// planning_bench --benchmark_filter=Bounded
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/planning/excuse.h"
#include "common/planning/ground_model.h"
#include "common/planning/ground_ppddl.h"
#include "common/planning/planner.h"
#include "common/planning/state_table.h"
#include "common/ppddl/problem.h"
#include "tests/unit/ladder_ppddl.h"

namespace cell::planning {
namespace {

GroundTask LadderTask(int length, ConstantAtoms constants) {
  const auto domain = ppddl::ParseDomain(kRover, "rover");
  const auto problem =
      ppddl::ParseProblem(LadderProblem(length), "ladder", domain);
  const auto task = GroundPpddl(domain, problem, constants);
  if (!task) throw std::runtime_error(task.reason());
  return *task;
}

/// The highest probability of reaching the goal, from below, over all states.
class PlainValueIteration {
 public:
  explicit PlainValueIteration(const GroundModel& model)
      : table_(model.num_words()), expansion_(model.num_words()) {
    table_.Enter(model.initial());
    for (int s = 0; s < table_.size(); ++s) {
      const std::vector<uint64_t> words(table_.Words(s).begin(),
                                        table_.Words(s).end());
      value_.push_back(model.IsGoal(words) ? 1 : 0);
      choices_.emplace_back();
      if (value_.back() == 1) continue;
      expansion_.Clear();
      model.Expand(words, &expansion_);
      for (const auto& choice : expansion_.choices()) {
        choices_.back().emplace_back();
        for (int i = 0; i < choice.num_outcomes; ++i) {
          const int outcome = choice.first_outcome + i;
          choices_.back().back().emplace_back(
              table_.Enter(expansion_.state(outcome)),
              expansion_.probability(outcome));
        }
      }
    }
  }

  double Solve() {
    for (double change = 1; change > 1e-9;) {
      change = 0;
      for (size_t s = value_.size(); s-- > 0;) {
        double best = value_[s];
        for (const auto& choice : choices_[s]) {
          double sum = 0;
          for (const auto& [next, p] : choice) {
            sum += p * value_[static_cast<size_t>(next)];
          }
          best = std::max(best, sum);
        }
        change = std::max(change, best - value_[s]);
        value_[s] = best;
      }
    }
    return value_[0];
  }
  int num_states() const { return table_.size(); }

 private:
  StateTable table_;
  Expansion expansion_;
  std::vector<double> value_;
  std::vector<std::vector<std::vector<std::pair<int, double>>>> choices_;
};

void PlainValueIterationOverLadder(benchmark::State& state) {
  const int length = static_cast<int>(state.range(0));
  for (auto _ : state) {
    const GroundModel model(LadderTask(length, ConstantAtoms::kReplace));
    PlainValueIteration iteration(model);
    state.counters["probability"] = iteration.Solve();
    state.counters["states"] = iteration.num_states();
  }
}
BENCHMARK(PlainValueIterationOverLadder)
    ->DenseRange(4, 12, 2)
    ->Unit(benchmark::kMillisecond);

void PlanOverLadder(benchmark::State& state, bool minimizes_actions) {
  const int length = static_cast<int>(state.range(0));
  Planner::Params params;
  params.minimize_actions = minimizes_actions;
  for (auto _ : state) {
    const auto model = std::make_shared<GroundModel>(
        LadderTask(length, ConstantAtoms::kReplace));
    const Plan plan = Planner(model, params).Find(model->initial());
    state.counters["probability"] = plan.probability.low;
    state.counters["actions"] = plan.expected_actions;
    state.counters["states"] = static_cast<double>(plan.num_states);
  }
}
void BoundedSearchOverLadder(benchmark::State& state) {
  PlanOverLadder(state, false);
}
void FewestActionsOverLadder(benchmark::State& state) {
  PlanOverLadder(state, true);
}
BENCHMARK(BoundedSearchOverLadder)
    ->DenseRange(4, 12, 2)
    ->Arg(25)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(FewestActionsOverLadder)
    ->DenseRange(4, 12, 2)
    ->Unit(benchmark::kMillisecond);

void ExcuseForAMissingWay(benchmark::State& state) {
  GroundTask task =
      LadderTask(static_cast<int>(state.range(0)), ConstantAtoms::kKeep);
  // Without a charge nothing goes.
  for (size_t atom = 0; atom < task.atoms.size(); ++atom) {
    if (task.atoms[atom].predicate == "charged") task.initial[atom] = false;
  }
  for (auto _ : state) {
    const Excuses excuses = FindExcuses(task);
    if (excuses.excuses.empty()) state.SkipWithError("no excuse");
  }
}
BENCHMARK(ExcuseForAMissingWay)
    ->DenseRange(2, 6, 2)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cell::planning

BENCHMARK_MAIN();
