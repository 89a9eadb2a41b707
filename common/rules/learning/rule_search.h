#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "common/rules/learning/induced.h"

namespace cell::rules {

/// A rule as the search keeps it. References and literals are those of the
/// action's FeatureTable; a reference names earlier ones only.
struct SearchRule {
  std::vector<int> references;
  std::vector<int> context;  ///< ascending
  BitSet covers;
  std::shared_ptr<const Induced> induced;
  /// Its part of S: log likelihood of what it covers, minus alpha PEN.
  double score = 0;
};

/// A change of a rule set: rules taken out, by index, and put in. Others that
/// cover an experience of an added rule are taken out, too.
struct Proposal {
  std::vector<size_t> removed;
  std::vector<SearchRule> added;
};

/// The rules of one action and their experiences: what the search operators
/// look at and propose to change. No experience is covered by two rules; those
/// that none covers belong to the default rule {no change, noise}.
class RuleSearch {
 public:
  RuleSearch(std::shared_ptr<const World> world, int action,
             const LearnerOptions& options);

  /// Rules that now cover an experience twice are dropped, the worse first.
  void Add(const Experience& experience);
  /// Applies operators until none improves the score.
  void Run();

  const LearnerOptions& options() const { return options_; }
  FeatureTable& table() { return table_; }
  const FeatureTable& table() const { return table_; }
  const std::vector<SearchRule>& rules() const { return rules_; }
  /// The action's part of S(R), eq. (1).
  double score() const;
  /// Proposals that were applied, ever.
  int num_steps() const { return num_steps_; }

  /// The rule with its outcomes; nullopt if it covers no experience.
  std::optional<SearchRule> Make(std::vector<int> references,
                                 std::vector<int> context);
  /// With one literal more, or without one of its context.
  std::optional<SearchRule> With(const SearchRule& rule, int literal);
  std::optional<SearchRule> Without(const SearchRule& rule, size_t index);
  /// With another term in place of a reference; without, for nullopt: then
  /// literals and references that name it go, too.
  std::optional<SearchRule> WithReference(const SearchRule& rule, int from,
                                          std::optional<int> to);

  /// All literals over the action's arguments and the references, plain ones
  /// first.
  const std::vector<int>& Literals(const std::vector<int>& references);
  /// All literals that may define a reference beside these.
  std::vector<Feature> Definitions(const std::vector<int>& references) const;

  double ScoreWith(const Proposal& proposal) const;
  void Apply(const Proposal& proposal);
  /// Experiences that no rule's outcome explains.
  BitSet Unexplained() const;
  /// Log likelihood of each experience by the rules.
  std::vector<double> LogLikelihoods() const;
  /// The rule that covers it; nullptr: the default rule.
  const SearchRule* CoveringRule(int e) const;

 private:
  struct KeyHash {
    size_t operator()(const std::pair<std::vector<int>, BitSet>& key) const;
  };

  std::shared_ptr<const Induced> Induce(const std::vector<int>& references,
                                        const BitSet& covers);
  double DefaultScore(const BitSet& rest) const;
  bool Step(size_t op);
  std::vector<bool> KeptWith(const Proposal& proposal) const;

  LearnerOptions options_;
  FeatureTable table_;
  ChangeLifter lifter_;
  std::vector<SearchRule> rules_;
  int num_steps_ = 0;
  std::unordered_map<std::pair<std::vector<int>, BitSet>,
                     std::shared_ptr<const Induced>, KeyHash>
      induced_;  // never iterated
  std::map<std::vector<int>, std::vector<int>> literals_;
};

}  // namespace cell::rules
