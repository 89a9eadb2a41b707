#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "common/rules/learning/rule_search.h"

namespace cell::rules {

/// Learns noisy deictic rules from experiences (Pasula, Zettlemoyer, Kaelbling,
/// JAIR 2007; section V-C): rules that maximise the score of eq. (1), found by
/// greedy search. No experience is covered by two rules. Equal experiences in
/// equal order, options and seed give equal rules.
///
/// Rules of different actions do not touch each other: experiences of one
/// action are learned from apart, and each action has a default rule {no
/// change, noise} of its own.
class Learner {
 public:
  Learner(std::shared_ptr<const World> world, const LearnerOptions& options);

  /// The next Learn() goes on from the rules that are there, and only for the
  /// actions of new experiences.
  /// @throws std::invalid_argument for an experience of another world
  void Add(const Experience& experience);
  void Learn();

  /// By action, in the order of the symbols; the rules that cover most first.
  NdrRules Rules() const;
  /// Experiences that each of them covers.
  std::vector<int> RuleCounts() const;
  /// S(R), eq. (1).
  double Score() const;
  /// The experiences of an action that its rules were learned from; nullptr if
  /// there are none.
  const RuleSearch* SearchOf(int action) const;

 private:
  std::vector<std::pair<const RuleSearch*, const SearchRule*>> SortedRules()
      const;

  std::shared_ptr<const World> world_;
  LearnerOptions options_;
  std::map<int, std::unique_ptr<RuleSearch>> searches_;  // by action
  std::map<int, bool> is_new_;
};

/// The rule of the search as a rule of its own.
Rule ToRule(const SearchRule& rule, const FeatureTable& table);

/// Log likelihood of an experience by rules that may not have been learned from
/// it: with probability `surprise` anything happens (p_min), else what the
/// rules say. Where none or several cover it, nothing changes in half of the
/// cases.
double LogLikelihood(const NdrRules& rules, const World& world,
                     const Experience& experience,
                     const LearnerOptions& options, double surprise = 0.01);

/// Mean log likelihood of the experiences, in `num_folds` parts of equal size
/// (experience i in part i mod num_folds), each by rules that were learned from
/// the other parts. With as many folds as experiences: leave one out.
double HeldOutLogLikelihood(const ExperienceSet& set,
                            const LearnerOptions& options, int num_folds);

}  // namespace cell::rules
