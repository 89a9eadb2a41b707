#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "services/cell/evaluations/evaluation.h"

namespace cell::cli {

/// Random manipulations, and noisy samples that are to be classified.
struct SecClassesParams {
  int num_classes = 20;
  size_t num_rows = 8;
  size_t num_columns = 8;
  int num_samples = 1000;  ///< per level, of these classes and of unseen ones
  uint64_t seed = 1;
  /// Every class has the same roles, so that only relations tell them apart.
  bool has_equal_roles = false;
};

/// How samples of one level were classified by one measure.
struct SecClassesResult {
  double noise = 0;  ///< p
  std::string measure;
  /// The best similarity of each sample, and whether its class has it.
  struct Sample {
    double similarity = 0;
    bool is_right = false;
  };
  std::vector<Sample> known;
  std::vector<double> unseen;  ///< best similarities, sorted

  int num_right() const;
  /// Area under the ROC curve: the probability that a sample of a known class
  /// is more similar to the nearest class than one of an unseen class.
  double area() const;
  /// Share of samples of known classes that reach `threshold` with the right
  /// class; and of samples of unseen ones that reach it.
  int NumAcceptedRight(double threshold) const;
  double FalseAccepts(double threshold) const;
};

/// Classes are RandomChain()s; each draws the roles of its rows from as many
/// roles as it has rows, less two, so that at least two rows repeat a role.
/// Samples have noise (ChainNoise) of p = 0, 0.1 ... 1 whose rows draw from the
/// same roles. As many classes again are never known. Measures are paper,
/// derivative, joint, typed, and SizeControl as `size only`. A sample goes to
/// the class it is most similar to, of equals the first.
///
/// @throws std::invalid_argument for fewer than 3 rows or 2 columns.
std::vector<SecClassesResult> ClassifySamples(
    const SecClassesParams& params,
    const std::function<void(const std::string&)>& show);

/// The least threshold, for all levels, that at most `share` of the samples of
/// unseen classes reach.
double ThresholdFor(double share, const std::string& measure,
                    const std::vector<SecClassesResult>& results);

/// The goals: accuracy of typed and joint; samples accepted and right by one
/// threshold of typed.
std::vector<Measure> ClassMeasures(
    const std::vector<SecClassesResult>& results);

/// A line per level and measure.
std::string ClassesToCsv(const std::vector<SecClassesResult>& results);
/// A line per level, measure and threshold.
std::string RocToCsv(const std::vector<SecClassesResult>& results);
/// The program by which gnuplot draws both into `png`.
std::string ClassesPlot(const std::string& accuracy_csv,
                        const std::string& png);

}  // namespace cell::cli
