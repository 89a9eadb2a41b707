#include "services/cell/evaluations/sec_groups.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <random>

#include "common/sec/chain_clustering.h"
#include "common/sec/chain_noise.h"
#include "common/sec/joint_similarity.h"
#include "common/sec/paper_similarity.h"
#include "common/sec/typed_similarity.h"
#include "services/cell/evaluations/sec_seeds.h"

namespace cell::cli {
namespace {

struct Variant {
  std::string name;
  ChainClustering::Params params;
};

template <class Similarity>
Variant MakeVariant(const std::string& name,
                    ChainClustering::Threshold threshold,
                    ChainClustering::Compared compared) {
  Variant variant{name, {}};
  variant.params.similarity = std::make_shared<Similarity>();
  variant.params.threshold = threshold;
  variant.params.compared = compared;
  variant.params.model.roles = std::is_same_v<Similarity, TypedSimilarity>
                                   ? RowRoles::kKept
                                   : RowRoles::kIgnored;
  return variant;
}

std::vector<Variant> AllVariants() {
  using enum ChainClustering::Threshold;
  using enum ChainClustering::Compared;
  std::vector<Variant> highest = {
      MakeVariant<JointSimilarity>("joint, highest cut", kHighestCut,
                                   kConsensus),
      MakeVariant<TypedSimilarity>("typed, highest cut", kHighestCut,
                                   kConsensus)};
  for (Variant& variant : highest) variant.params.first_threshold = 0.9;
  std::vector<Variant> all = {
      MakeVariant<PaperSimilarity>("paper, tau (as printed)", kMeanOfHigh,
                                   kAll),
      MakeVariant<PaperSimilarity>("paper, cut", kCut, kAll),
      MakeVariant<JointSimilarity>("joint, cut, consensus", kCut, kConsensus),
      MakeVariant<TypedSimilarity>("typed, tau", kMeanOfHigh, kAll),
      MakeVariant<TypedSimilarity>("typed, cut", kCut, kAll),
      MakeVariant<TypedSimilarity>("typed, tau, consensus", kMeanOfHigh,
                                   kConsensus),
      MakeVariant<TypedSimilarity>(kImprovedGrouping, kCut, kConsensus)};
  all.insert(all.end(), highest.begin(), highest.end());
  return all;
}

struct LabelledSample {
  size_t label = 0;  // of its seed
  RelationMatrix chain;
};

std::vector<LabelledSample> MakeSamples(const SecGroupsParams& params,
                                        uint64_t seed) {
  RoleTable roles;
  const auto seeds = DistinctSeeds(&roles);
  std::mt19937_64 random(seed);
  std::vector<LabelledSample> samples;
  for (int i = 0; i < params.num_samples; ++i) {
    const size_t label = static_cast<size_t>(i) % seeds.size();
    samples.push_back(
        {label, WithNoise(seeds[label].chain, {params.noise}, random)});
  }
  for (size_t i = samples.size(); i > 1; --i) {
    std::swap(samples[i - 1], samples[DrawBelow(i, random)]);
  }
  return samples;
}

int NumRight(const std::vector<ChainClustering::Cluster>& clusters,
             const std::vector<LabelledSample>& samples) {
  std::vector<int> largest;
  for (const auto& cluster : clusters) {
    std::vector<int> counts;
    for (const size_t i : cluster.samples) {
      counts.resize(std::max(counts.size(), samples[i].label + 1));
      ++counts[samples[i].label];
    }
    const auto most = std::ranges::max_element(counts);
    const auto label = static_cast<size_t>(most - counts.begin());
    largest.resize(std::max(largest.size(), label + 1));
    largest[label] = std::max(largest[label], *most);
  }
  int num_right = 0;
  for (const int count : largest) num_right += count;
  return num_right;
}

bool HasFiveModels(const SecGroupsResult& result) {
  return std::abs(static_cast<int>(result.num_models) - 5) <= 1;
}

}  // namespace

std::vector<SecGroupsResult> GroupSamples(
    const SecGroupsParams& params,
    const std::function<void(const std::string&)>& show) {
  std::vector<SecGroupsResult> results;
  for (const Variant& variant : AllVariants()) {
    for (int order = 0; order < params.num_orders; ++order) {
      show(fmt::format("{}, order {}/{}", variant.name, order + 1,
                       params.num_orders));
      const uint64_t seed = params.seed + static_cast<uint64_t>(order);
      const auto samples = MakeSamples(params, seed);
      ChainClustering clustering(variant.params);
      for (const LabelledSample& sample : samples) clustering.Add(sample.chain);
      results.push_back({variant.name, seed, clustering.clusters().size(),
                         params.num_samples,
                         NumRight(clustering.clusters(), samples)});
    }
  }
  return results;
}

std::vector<Measure> GroupMeasures(
    const std::vector<SecGroupsResult>& results) {
  Measure orders{"orders with 5 +- 1 models", 0, 0, std::nullopt, 1};
  Measure right{"samples in the model of their seed", 0, 0, std::nullopt, 0.95};
  for (const SecGroupsResult& result : results) {
    if (result.variant != kImprovedGrouping) continue;
    ++orders.num_all;
    orders.num_good += HasFiveModels(result);
    right.num_all += result.num_samples;
    right.num_good += result.num_right;
  }
  return {orders, right};
}

std::string GroupsToCsv(const std::vector<SecGroupsResult>& results) {
  std::string text = "variant,seed,models,samples,right\n";
  for (const SecGroupsResult& result : results) {
    text +=
        fmt::format("\"{}\",{},{},{},{}\n", result.variant, result.seed,
                    result.num_models, result.num_samples, result.num_right);
  }
  return text;
}

std::string GroupsTable(const std::vector<SecGroupsResult>& results) {
  std::string text =
      fmt::format("{:28} {:>16} {:>10} {:>9} {:>9}\n", "decision", "models",
                  "5 +- 1 in", "right", "worst");
  for (const Variant& variant : AllVariants()) {
    size_t sum = 0, least = SIZE_MAX, most = 0;
    int num_orders = 0, num_five = 0, num_right = 0, num_samples = 0;
    double worst = 1;
    for (const SecGroupsResult& result : results) {
      if (result.variant != variant.name) continue;
      ++num_orders;
      num_five += HasFiveModels(result);
      sum += result.num_models;
      least = std::min(least, result.num_models);
      most = std::max(most, result.num_models);
      num_right += result.num_right;
      num_samples += result.num_samples;
      worst = std::min(
          worst, static_cast<double>(result.num_right) / result.num_samples);
    }
    if (num_orders == 0) continue;
    text += fmt::format(
        "{:28} {:4.1f} ({:2} to {:2})  {:>10} {:7.1f} % {:7.1f} %\n",
        variant.name, static_cast<double>(sum) / num_orders, least, most,
        fmt::format("{}/{}", num_five, num_orders),
        100.0 * num_right / num_samples, 100 * worst);
  }
  return text;
}

}  // namespace cell::cli
