#include "common/sec/chain_clustering.h"

#include <algorithm>
#include <stdexcept>

#include "common/sec/similarity_cut.h"

namespace cell {

ChainClustering::ChainClustering(const Params& params) : params_(params) {
  if (!params_.similarity) throw std::invalid_argument("no similarity");
}

double ChainClustering::threshold() const {
  if (similarities_.size() < params_.num_first) return params_.first_threshold;
  switch (params_.threshold) {
    case Threshold::kCut:
      return OtsuCut(similarities_);
    case Threshold::kHighestCut:
      return HighestCut(similarities_);
    case Threshold::kMeanOfHigh:
      break;
  }
  return MeanFrom(OtsuCut(similarities_), similarities_);
}

void ChainClustering::Add(const RelationMatrix& sample) {
  if (sample.is_empty()) {
    throw std::invalid_argument("an event chain without rows or columns");
  }
  if (params_.threshold == Threshold::kHighestCut && !has_distribution_ &&
      similarities_.size() >= params_.num_first) {
    has_distribution_ = true;
    MergeAll();
  }
  double best = -1;
  size_t nearest = 0;
  for (size_t i = 0; i < clusters_.size(); ++i) {
    const double similarity =
        params_.similarity->Between(ComparedPart(clusters_[i]), sample);
    similarities_.push_back(similarity);
    if (similarity > best) {
      best = similarity;
      nearest = i;
    }
  }
  if (best < threshold()) {
    clusters_.push_back({ChainModel(sample, params_.model), {num_samples_++}});
    return;
  }
  clusters_[nearest].model.Update(sample);
  clusters_[nearest].samples.push_back(num_samples_++);
  MergeWith(nearest);
}

RelationMatrix ChainClustering::ComparedPart(const Cluster& cluster) const {
  return params_.compared == Compared::kAll ? cluster.model.chain()
                                            : cluster.model.Consensus();
}

void ChainClustering::MergeAll() {
  for (size_t i = 0; i < clusters_.size();) {
    const size_t num_before = clusters_.size();
    MergeWith(i);
    i = clusters_.size() < num_before ? 0 : i + 1;
  }
}

// Merges the cluster that has changed with those that have become as similar
// to it as a sample has to be; the older one stays.
void ChainClustering::MergeWith(size_t changed) {
  const double threshold = this->threshold();
  for (size_t i = 0; i < clusters_.size(); ++i) {
    if (i == changed) continue;
    const double similarity = params_.similarity->Between(
        ComparedPart(clusters_[i]), ComparedPart(clusters_[changed]));
    if (similarity < threshold) continue;
    const auto [kept, merged] = std::minmax(i, changed);
    clusters_[kept].model.Merge(clusters_[merged].model);
    auto& samples = clusters_[kept].samples;
    samples.insert(samples.end(), clusters_[merged].samples.begin(),
                   clusters_[merged].samples.end());
    std::ranges::sort(samples);
    clusters_.erase(clusters_.begin() + static_cast<ptrdiff_t>(merged));
    return MergeWith(kept);
  }
}

}  // namespace cell
