#include <cmath>
#include <stdexcept>

#include "common/rules/learning/learner.h"

namespace cell::rules {

double LogLikelihood(const NdrRules& rules, const World& world,
                     const Experience& experience,
                     const LearnerOptions& options, double surprise) {
  const auto coverage =
      FindCoverage(rules, experience.act, experience.before, world);
  double p = 0;
  if (!coverage) {
    const bool is_same = experience.before.bits == experience.after.bits &&
                         experience.before.values == experience.after.values;
    return std::log(is_same ? 0.5 : 0.5 * options.p_min_default);
  }
  for (const Outcome& outcome : coverage->rule->outcomes) {
    const WorldState after =
        Apply(outcome, coverage->binding, experience.before, world);
    if (after.bits == experience.after.bits &&
        after.values == experience.after.values) {
      p += outcome.probability;
    }
  }
  p += coverage->rule->noise * options.p_min;
  return std::log((1 - surprise) * p + surprise * options.p_min);
}

double HeldOutLogLikelihood(const ExperienceSet& set,
                            const LearnerOptions& options, int num_folds) {
  const size_t n = set.experiences.size();
  const auto folds = static_cast<size_t>(num_folds);
  if (num_folds < 2 || folds > n) {
    throw std::invalid_argument("from 2 folds to one for each experience");
  }
  double sum = 0;
  for (size_t fold = 0; fold < folds; ++fold) {
    Learner learner(set.world, options);
    for (size_t i = 0; i < n; ++i) {
      if (i % folds != fold) learner.Add(set.experiences[i]);
    }
    learner.Learn();
    const NdrRules rules = learner.Rules();
    for (size_t i = fold; i < n; i += folds) {
      sum += LogLikelihood(rules, *set.world, set.experiences[i], options);
    }
  }
  return sum / static_cast<double>(n);
}

}  // namespace cell::rules
