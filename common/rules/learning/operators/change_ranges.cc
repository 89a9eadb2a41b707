#include "common/rules/learning/operators/operators.h"

namespace cell::rules {

void ChangeRanges(RuleSearch& search, const Propose& propose) {
  for (size_t i = 0; i < search.rules().size(); ++i) {
    const SearchRule& rule = search.rules()[i];
    for (size_t k = 0; k < rule.context.size(); ++k) {
      Feature feature = search.table().feature(rule.context[k]);
      if (feature.comparison != Comparison::kAtMost &&
          feature.comparison != Comparison::kAtLeast) {
        continue;
      }
      const auto rest = search.Without(rule, k);
      for (const int value : search.table().ValuesOf(feature.symbol)) {
        feature.value = value;
        const int number = search.table().Number(feature);
        if (auto other = search.With(*rest, number)) propose({{i}, {*other}});
      }
    }
  }
}

}  // namespace cell::rules
