#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/task/task.h"
#include "services/cell/evaluations/evaluation.h"
#include "services/cell/evaluations/shown_groups.h"

namespace cell::cli {

/// How well a similarity tells actions apart, over all pairs of placements.
struct Separation {
  /// Probability that two placements of one action are more similar than two
  /// of different actions; half of what is equal counts.
  double area = 0;
  /// d': the difference of the mean similarities within an action and between
  /// actions, in units of their pooled standard deviation.
  double d_prime = 0;
};

/// A measure that compares some layers of enriched event chains.
struct LayerAblation {
  std::string measure;  ///< "joint" or "typed"
  std::string layers;   ///< "touching", "touching + static", ...
  Separation separation;
  /// Above the same measure of touching alone, with the 95 % interval of a
  /// bootstrap over placements.
  Separation gain, gain_low, gain_high;
  int num_right = 0;  ///< placements whose most similar other is of the action
  int num_all = 0;
};

/// Compares all pairs of the placements, which must be of more than one action.
/// @param seed  of the bootstrap
/// @throws std::invalid_argument otherwise.
std::vector<LayerAblation> AblateLayers(const std::vector<ShownChain>& chains,
                                        const Task& task, uint64_t seed);

/// A line per measure and choice of layers.
std::string LayersTable(const std::vector<LayerAblation>& results);
std::string LayersToCsv(const std::vector<LayerAblation>& results,
                        uint64_t seed, double noise_mm);

}  // namespace cell::cli
