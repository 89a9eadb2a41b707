#pragma once

#include <map>
#include <vector>

#include "common/rules/learning/feature_table.h"
#include "common/rules/learning/options.h"

namespace cell::rules {

struct InducedOutcome {
  std::vector<Feature> changes;
  BitSet covers;  ///< experiences that it explains
  double probability = 0;
};

/// What a rule says of the experiences that it covers.
struct Induced {
  std::vector<InducedOutcome> outcomes;
  double noise = 0;
  double log_likelihood = 0;
  int num_literals = 0;
};

/// The most likely probabilities of the outcomes and the noise of a rule that
/// covers the experiences (LearnParameters of Pasula et al.). Counts if each
/// experience has at most one outcome; otherwise expectation maximisation of
/// the likelihood, which is concave.
void LearnParameters(const BitSet& covered, double p_min, Induced* induced);

/// Likelihood of an experience by outcomes whose probabilities are known.
double Likelihood(const Induced& induced, int e, double p_min);

/// Changes of experiences in terms of a rule's variables.
class ChangeLifter {
 public:
  explicit ChangeLifter(FeatureTable* table) : table_(table) {}

  /// Numbers of the changes of all experiences; -1 if an object is none of the
  /// variables. Of several variables that stand for it, the first counts.
  const std::vector<int>& Lift(const std::vector<int>& references);
  const std::vector<Feature>& changes(int number) const {
    return pool_[static_cast<size_t>(number)];
  }

 private:
  int LiftOne(const std::vector<int>& references, int e);

  FeatureTable* table_;
  std::map<std::vector<int>, std::vector<int>> lifted_;
  std::vector<std::vector<Feature>> pool_;
  std::map<std::vector<Feature>, int> number_of_;
};

/// InduceOutcomes of Pasula et al.: from the distinct changes of the covered
/// experiences, by removing outcomes and conjoining two as long as likelihood
/// minus penalty rises.
Induced InduceOutcomes(const std::vector<int>& references,
                       const BitSet& covered, const LearnerOptions& options,
                       FeatureTable* table, ChangeLifter* lifter);

}  // namespace cell::rules
