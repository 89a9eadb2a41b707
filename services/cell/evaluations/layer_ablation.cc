#include "services/cell/evaluations/layer_ablation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>

#include "common/sec/chain_noise.h"
#include "common/sec/layered_similarity.h"

namespace cell::cli {
namespace {

constexpr int kNumResamples = 200;
constexpr double kTail = 0.025;  // of a 95 % interval, at either end

/// Two placements, and whether they are of one action.
struct ComparedPair {
  size_t i, j;
  double similarity;
  bool is_same;
};

struct Choice {
  const char* layers;
  bool has_places, has_motions;
};
constexpr Choice kChoices[] = {{"touching", false, false},
                               {"touching + static", true, false},
                               {"touching + dynamic", false, true},
                               {"all", true, true}};

/// All pairs, by similarity.
std::vector<ComparedPair> CompareAll(const std::vector<ShownChain>& chains,
                                     const LayeredSimilarity& similarity) {
  std::vector<ComparedPair> pairs;
  for (size_t i = 0; i < chains.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      pairs.push_back(
          {i, j, similarity.Between(chains[i].enriched, chains[j].enriched),
           chains[i].action == chains[j].action});
    }
  }
  std::ranges::stable_sort(pairs, {}, &ComparedPair::similarity);
  return pairs;
}

/// Weighted sums of the similarities of one sort of pairs.
struct Moments {
  double weight = 0, sum = 0, squares = 0;

  void Add(double w, double value) {
    weight += w;
    sum += w * value;
    squares += w * value * value;
  }
  double Mean() const { return sum / weight; }
  double Variance() const { return squares / weight - Mean() * Mean(); }
};

/// @param counts  how often each placement is there
Separation SeparationOf(const std::vector<ComparedPair>& pairs,
                        const std::vector<int>& counts) {
  Moments same, different;
  double won = 0;
  for (size_t first = 0; first < pairs.size();) {
    const double below = different.weight, same_below = same.weight;
    size_t next = first;
    for (; next < pairs.size() &&
           pairs[next].similarity == pairs[first].similarity;
         ++next) {
      const ComparedPair& pair = pairs[next];
      const double weight = counts[pair.i] * counts[pair.j];
      (pair.is_same ? same : different).Add(weight, pair.similarity);
    }
    won += (same.weight - same_below) * (below + different.weight) / 2;
    first = next;
  }
  const double pooled =
      std::sqrt(std::max(0.0, (same.Variance() + different.Variance()) / 2));
  const double gap = same.Mean() - different.Mean();
  return {won / (same.weight * different.weight),
          pooled > 0 ? gap / pooled : 0};
}

Separation Minus(const Separation& a, const Separation& b) {
  return {a.area - b.area, a.d_prime - b.d_prime};
}

/// Ties between actions are not right.
int NumNearestRight(const std::vector<ComparedPair>& pairs, size_t num) {
  std::vector<double> best_same(num, -1), best_other(num, -1);
  for (const ComparedPair& pair : pairs) {
    for (const size_t i : {pair.i, pair.j}) {
      double& best = pair.is_same ? best_same[i] : best_other[i];
      best = std::max(best, pair.similarity);
    }
  }
  int num_right = 0;
  for (size_t i = 0; i < num; ++i) num_right += best_same[i] > best_other[i];
  return num_right;
}

/// How often each placement is drawn, for every resample.
std::vector<std::vector<int>> Resamples(size_t num, uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<int>> resamples(kNumResamples);
  for (std::vector<int>& counts : resamples) {
    counts.resize(num);
    for (size_t k = 0; k < num; ++k) ++counts[DrawBelow(num, random)];
  }
  return resamples;
}

void SetInterval(std::vector<Separation> gains, LayerAblation* result) {
  const auto low = static_cast<size_t>(kTail * kNumResamples);
  const size_t high = gains.size() - 1 - low;
  std::ranges::sort(gains, {}, &Separation::area);
  result->gain_low.area = gains[low].area;
  result->gain_high.area = gains[high].area;
  std::ranges::sort(gains, {}, &Separation::d_prime);
  result->gain_low.d_prime = gains[low].d_prime;
  result->gain_high.d_prime = gains[high].d_prime;
}

std::vector<LayerAblation> AblateMeasure(
    const std::vector<ShownChain>& chains, const std::string& measure,
    const LayeredSimilarity::Params& params,
    const std::vector<std::vector<int>>& resamples) {
  const std::vector<int> once(chains.size(), 1);
  std::vector<LayerAblation> results;
  std::vector<Separation> of_touching;  // by resample
  for (const Choice& choice : kChoices) {
    LayeredSimilarity::Params of_choice = params;
    of_choice.has_places = choice.has_places;
    of_choice.has_motions = choice.has_motions;
    const auto pairs = CompareAll(chains, LayeredSimilarity(of_choice));
    LayerAblation& result = results.emplace_back();
    result.measure = measure;
    result.layers = choice.layers;
    result.separation = SeparationOf(pairs, once);
    result.gain = Minus(result.separation, results.front().separation);
    result.num_all = static_cast<int>(chains.size());
    result.num_right = NumNearestRight(pairs, chains.size());
    std::vector<Separation> gains;
    for (const std::vector<int>& counts : resamples) {
      const Separation resampled = SeparationOf(pairs, counts);
      if (results.size() == 1) of_touching.push_back(resampled);
      gains.push_back(Minus(resampled, of_touching[gains.size()]));
    }
    SetInterval(std::move(gains), &result);
  }
  return results;
}

}  // namespace

std::vector<LayerAblation> AblateLayers(const std::vector<ShownChain>& chains,
                                        const Task& task, uint64_t seed) {
  std::set<std::string> actions;
  for (const ShownChain& shown : chains) actions.insert(shown.action);
  if (actions.size() < 2 || chains.size() == actions.size()) {
    throw std::invalid_argument(fmt::format(
        "{} placements of {} actions are too few: there is nothing to tell "
        "apart, or nothing alike",
        chains.size(), actions.size()));
  }
  const auto resamples = Resamples(chains.size(), seed);
  auto results = AblateMeasure(
      chains, "joint", {.roles = RowRoles::kIgnored, .types = {}}, resamples);
  auto typed = AblateMeasure(chains, "typed",
                             {.roles = RowRoles::kKept, .types = TypesOf(task)},
                             resamples);
  results.insert(results.end(), typed.begin(), typed.end());
  return results;
}

std::string LayersTable(const std::vector<LayerAblation>& results) {
  std::string text = fmt::format(
      "{:6} {:20} {:>10} {:>26} {:>6} {:>22} {:>9}\n", "", "compared",
      "separation", "gain (95 %)", "d'", "gain (95 %)", "nearest");
  for (const LayerAblation& r : results) {
    text += fmt::format(
        "{:6} {:20} {:10.4f} {:>+8.4f} [{:+.4f}, {:+.4f}] {:6.2f} {:>+6.2f} "
        "[{:+.2f}, {:+.2f}] {:>9}\n",
        r.measure, r.layers, r.separation.area, r.gain.area, r.gain_low.area,
        r.gain_high.area, r.separation.d_prime, r.gain.d_prime,
        r.gain_low.d_prime, r.gain_high.d_prime,
        fmt::format("{}/{}", r.num_right, r.num_all));
  }
  return text;
}

std::string LayersToCsv(const std::vector<LayerAblation>& results,
                        uint64_t seed, double noise_mm) {
  std::string text =
      "seed,noise_mm,measure,layers,placements,separation,gain,gain_low,"
      "gain_high,d_prime,d_prime_gain,d_prime_gain_low,d_prime_gain_high,"
      "nearest_right\n";
  for (const LayerAblation& r : results) {
    text += fmt::format(
        "{},{:g},{},{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.4f},{:.4f},{:.4f},"
        "{:.4f},{}\n",
        seed, noise_mm, r.measure, r.layers, r.num_all, r.separation.area,
        r.gain.area, r.gain_low.area, r.gain_high.area, r.separation.d_prime,
        r.gain.d_prime, r.gain_low.d_prime, r.gain_high.d_prime, r.num_right);
  }
  return text;
}

}  // namespace cell::cli
