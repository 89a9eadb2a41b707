#pragma once

#include <memory>
#include <vector>

#include "common/sec/chain_model.h"
#include "common/sec/matrix_similarity.h"

namespace cell {

/// Groups samples of manipulations online and without names (section VI-A,
/// Fig. 11). A sample is compared with all models; these similarities join the
/// similarity matrix; its histogram is divided by Otsu's method, which gives
/// the threshold. The sample updates the most similar model if that similarity
/// reaches the threshold, or else becomes a model. Models that are as similar
/// to each other are merged.
class ChainClustering {
 public:
  /// What a similarity must reach.
  enum class Threshold : int8_t {
    kMeanOfHigh,  ///< tau as printed: the mean of those above the cut; about
                  ///< half of the true matches lie below
    kCut,         ///< the cut between low and high itself
    kHighestCut   ///< the highest cut (HighestCut)
  };
  /// What of a model samples are compared with.
  enum class Compared : int8_t { kAll, kConsensus };

  struct Params {
    std::shared_ptr<const MatrixSimilarity> similarity;
    Threshold threshold = Threshold::kCut;
    Compared compared = Compared::kConsensus;
    /// The threshold before there is a distribution to divide: the paper's. A
    /// high one keeps apart what the highest cut merges once there is.
    double first_threshold = 0.64;
    /// Similarities from which on the distribution decides.
    size_t num_first = 100;
    ChainModel::Params model;
  };
  struct Cluster {
    ChainModel model;
    std::vector<size_t> samples;  ///< numbers, in the order of their coming
  };

  /// @throws std::invalid_argument without a similarity.
  explicit ChainClustering(const Params& params);

  /// Samples are numbered from 0. @throws std::invalid_argument for a sample
  /// without entries.
  void Add(const RelationMatrix& sample);

  const std::vector<Cluster>& clusters() const { return clusters_; }
  double threshold() const;
  /// All similarities of samples with the models of their time.
  const std::vector<double>& similarities() const { return similarities_; }

 private:
  RelationMatrix ComparedPart(const Cluster& cluster) const;
  void MergeWith(size_t changed);
  void MergeAll();

  Params params_;
  size_t num_samples_ = 0;
  bool has_distribution_ = false;  // decides the threshold
  std::vector<Cluster> clusters_;
  std::vector<double> similarities_;
};

}  // namespace cell
