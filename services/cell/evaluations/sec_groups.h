#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// Noisy samples of DistinctSeeds(), grouped online in random order.
struct SecGroupsParams {
  int num_orders = 20;
  int num_samples = 150;  ///< of all seeds together, equally many of each
  double noise = 0.1;     ///< p
  uint64_t seed = 1;      ///< of the first order
};

/// One order, grouped by one way to decide.
struct SecGroupsResult {
  std::string variant;
  uint64_t seed = 0;
  size_t num_models = 0;
  int num_samples = 0;
  /// Samples in the model that stands for their seed: of the models in which
  /// the seed has most samples, the largest. Samples that are split off into
  /// further models count as wrong.
  int num_right = 0;
};

/// The variant whose goals are set: roles kept, the cut itself, consensus.
inline constexpr char kImprovedGrouping[] = "typed, cut, consensus";

std::vector<SecGroupsResult> GroupSamples(
    const SecGroupsParams& params,
    const std::function<void(const std::string&)>& show);

/// Of the improved variant: orders with 5 +- 1 models, samples that are right.
std::vector<Measure> GroupMeasures(const std::vector<SecGroupsResult>& results);

/// A line per variant and order.
std::string GroupsToCsv(const std::vector<SecGroupsResult>& results);
/// A line per variant: models (mean, least, most), orders with 5 +- 1, right.
std::string GroupsTable(const std::vector<SecGroupsResult>& results);

}  // namespace cell::cli
