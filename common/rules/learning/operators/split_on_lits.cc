#include <set>

#include "common/rules/learning/operators/operators.h"

namespace cell::rules {
namespace {

/// The literal and, of "f = v", also "f at most v".
std::vector<Feature> SplitsBy(const Feature& feature) {
  std::vector<Feature> features = {feature};
  if (feature.comparison == Comparison::kEqual) {
    features.push_back(feature);
    features.back().comparison = Comparison::kAtMost;
  }
  return features;
}

}  // namespace

void SplitOnLits(RuleSearch& search, const Propose& propose) {
  FeatureTable& table = search.table();
  for (size_t i = 0; i < search.rules().size(); ++i) {
    const SearchRule& rule = search.rules()[i];
    std::set<uint64_t> tried = {rule.covers.Hash()};
    for (const int literal : search.Literals(rule.references)) {
      for (const Feature& feature : SplitsBy(table.feature(literal))) {
        const int number = table.Number(feature);
        BitSet covers = rule.covers;
        covers &= table.Before(number);
        BitSet others = rule.covers;
        others -= covers;
        if (covers.IsEmpty() || !tried.insert(covers.Hash()).second) continue;
        if (!tried.insert(others.Hash()).second) continue;
        const auto with = search.With(rule, number);
        const auto without = search.With(rule, table.Number(feature.Negated()));
        // The negation of a function that has no value does not hold either.
        if (with && without) propose({{i}, {*with, *without}});
      }
    }
  }
}

}  // namespace cell::rules
