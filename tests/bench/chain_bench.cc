// What it costs to compare event chains, beside the same measures written
// plainly with vectors, and to find the most similar of many models, beside
// comparing them all. Models are random chains of 8x8 whose rows draw from six
// roles (RandomChain); queries are models with noise of p = 0.2.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include "common/sec/assignment.h"
#include "common/sec/chain_alignment.h"
#include "common/sec/chain_index.h"
#include "common/sec/chain_noise.h"
#include "common/sec/derivative_similarity.h"
#include "common/sec/joint_similarity.h"
#include "common/sec/paper_similarity.h"

namespace cell {
namespace {

constexpr size_t kNumRoles = 6;
constexpr double kNoise = 0.2;

using Chains = std::vector<RelationMatrix>;

Chains RandomChains(size_t count, size_t num_rows, size_t num_columns) {
  std::mt19937_64 random(1);
  Chains chains;
  for (size_t i = 0; i < count; ++i) {
    std::vector<uint32_t> roles(num_rows);
    for (uint32_t& role : roles) {
      role = static_cast<uint32_t>(DrawBelow(kNumRoles, random));
    }
    chains.push_back(RandomChain(roles, num_columns, random).Sorted());
  }
  return chains;
}

Chains NoisyChains(const Chains& chains) {
  std::mt19937_64 random(2);
  Chains noisy;
  for (const RelationMatrix& chain : chains) {
    noisy.push_back(WithNoise(chain, {kNoise}, random).Sorted());
  }
  return noisy;
}

// The measures with a vector per row and table, entries compared one by one.
class PlainComparison {
 public:
  PlainComparison(const RelationMatrix& a, const RelationMatrix& b) {
    for (const auto& [matrix, rows] : {std::pair{&a, &a_}, {&b, &b_}}) {
      for (size_t i = 0; i < matrix->num_rows(); ++i) {
        rows->emplace_back(matrix->Row(i).begin(), matrix->Row(i).end());
      }
    }
  }

  int EqualByPaper() const {
    std::vector<int> weights;
    for (const auto& row : a_) {
      for (const auto& other : b_) weights.push_back(LongestCommon(row, other));
    }
    return BestOverColumns(Correspond(weights));
  }

 private:
  using Row = std::vector<uint8_t>;

  static int LongestCommon(const Row& a, const Row& b) {
    return BestInOrder(a.size(), b.size(), [&](size_t u, size_t v) {
      return static_cast<int>(a[u] == b[v]);
    });
  }

  template <class Gain>
  static int BestInOrder(size_t num_a, size_t num_b, Gain gain) {
    std::vector<std::vector<int>> best(num_a + 1, std::vector<int>(num_b + 1));
    for (size_t u = 0; u < num_a; ++u) {
      for (size_t v = 0; v < num_b; ++v) {
        best[u + 1][v + 1] =
            std::max({best[u][v] + gain(u, v), best[u][v + 1], best[u + 1][v]});
      }
    }
    return best[num_a][num_b];
  }

  LinePairs Correspond(const std::vector<int>& weights) const {
    Assignment assignment;
    LinePairs rows;
    const auto columns = assignment.Solve(weights, a_.size(), b_.size());
    for (size_t i = 0; i < columns.size(); ++i) {
      if (columns[i] == Assignment::kNone) continue;
      rows.emplace_back(i, static_cast<size_t>(columns[i]));
    }
    return rows;
  }

  int BestOverColumns(const LinePairs& rows) const {
    return BestInOrder(a_[0].size(), b_[0].size(), [&](size_t u, size_t v) {
      return static_cast<int>(std::ranges::count_if(rows, [&](const auto& r) {
        return a_[r.first][u] == b_[r.second][v];
      }));
    });
  }

  std::vector<Row> a_, b_;
};

void PlainPaper(benchmark::State& state) {
  const Chains chains = RandomChains(64, static_cast<size_t>(state.range(0)),
                                     static_cast<size_t>(state.range(1)));
  size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        PlainComparison(chains[i % 64], chains[(i + 1) % 64]).EqualByPaper());
    ++i;
  }
}
BENCHMARK(PlainPaper)->Args({8, 8})->Args({20, 60});

template <class Similarity>
void Pair(benchmark::State& state) {
  const Chains chains = RandomChains(64, static_cast<size_t>(state.range(0)),
                                     static_cast<size_t>(state.range(1)));
  const Similarity similarity;
  size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        similarity.Between(chains[i % 64], chains[(i + 1) % 64]));
    ++i;
  }
}
#define CELL_PAIR(Similarity) \
  BENCHMARK(Pair<Similarity>) \
      ->Args({8, 8})          \
      ->Args({16, 16})        \
      ->Args({32, 32})        \
      ->Args({20, 60})
CELL_PAIR(PaperSimilarity);
CELL_PAIR(DerivativeSimilarity);
CELL_PAIR(JointSimilarity);
CELL_PAIR(TypedSimilarity);

// Models by their number, and queries made of some of them.
struct Models {
  explicit Models(size_t count) {
    const Chains chains = RandomChains(count, 8, 8);
    for (const RelationMatrix& chain : chains) index.Add(chain);
    Chains some;
    for (size_t i = 0; i < 32; ++i) some.push_back(chains[i * 31 % count]);
    queries = NoisyChains(some);
  }
  static const Models& Of(size_t count) {
    static std::unique_ptr<Models> models;
    if (!models || models->index.size() != count) {
      models = std::make_unique<Models>(count);
    }
    return *models;
  }

  ChainIndex index;
  Chains queries;
};

ChainIndex::Match CompareAll(const ChainIndex& index,
                             const RelationMatrix& query) {
  const TypedSimilarity similarity;
  ChainIndex::Match best{0, -1, index.size()};
  for (size_t i = 0; i < index.size(); ++i) {
    const double value = similarity.Between(query, index.model(i));
    if (value > best.similarity) best = {i, value, index.size()};
  }
  return best;
}

void AllModels(benchmark::State& state) {
  const Models& models = Models::Of(static_cast<size_t>(state.range(0)));
  size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        CompareAll(models.index, models.queries[i++ % 32]));
  }
}

void IndexedModels(benchmark::State& state) {
  const Models& models = Models::Of(static_cast<size_t>(state.range(0)));
  size_t i = 0;
  double num_compared = 0;
  for (auto _ : state) {
    const auto match = models.index.MostSimilar(models.queries[i++ % 32]);
    num_compared += static_cast<double>(match->num_compared);
  }
  state.counters["compared"] = num_compared / static_cast<double>(i);
  for (size_t k = 0; k < 4; ++k) {
    const auto exhaustive = CompareAll(models.index, models.queries[k]);
    const auto match = models.index.MostSimilar(models.queries[k]);
    if (match->model != exhaustive.model ||
        match->similarity != exhaustive.similarity) {
      state.SkipWithError("another match than by comparing all");
    }
  }
}
BENCHMARK(IndexedModels)
    ->RangeMultiplier(10)
    ->Range(1000, 100'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(AllModels)
    ->RangeMultiplier(10)
    ->Range(1000, 100'000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cell

BENCHMARK_MAIN();
