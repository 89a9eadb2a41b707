#pragma once

#include <vector>

#include "common/relational/bound_condition.h"
#include "common/relational/rule.h"

namespace cell {

/// A rule with the objects of its action, as far as it can be worked out
/// without a state; see BoundCondition. For rules that are looked at in many
/// states.
class BoundRule {
 public:
  /// The rule and the vocabulary must outlive it.
  BoundRule(const NdrRule& rule, Binding arguments,
            const Vocabulary& vocabulary);

  const NdrRule& rule() const { return rule_; }
  /// False if it covers no state.
  bool is_possible() const {
    return !rule_.references.empty() || context_.is_possible();
  }
  /// True if ApplicableRules() of its action would name it.
  bool MayCover(const State& state) const;
  /// As Apply() of the outcome with the rule's binding; only where it may cover
  /// the state.
  State After(size_t outcome, const State& before) const;

 private:
  struct BoundEffect {
    BoundCondition where;
    struct Change {
      int atom;
      Truth truth;
    };
    std::vector<Change> then;
  };

  std::vector<BoundEffect> EffectsOf(const Outcome& outcome) const;

  const NdrRule& rule_;
  Binding arguments_;
  const Vocabulary& vocabulary_;
  // Of a rule without references; those of others depend on the state.
  BoundCondition context_;
  std::vector<std::vector<BoundEffect>> effects_;  // of each outcome
};

}  // namespace cell
