#include <algorithm>

#include "common/rules/learning/operators/operators.h"

namespace cell::rules {

void AddRefs(RuleSearch& search, const Propose& propose) {
  for (size_t i = 0; i < search.rules().size(); ++i) {
    const SearchRule& rule = search.rules()[i];
    for (const Feature& feature : search.Definitions(rule.references)) {
      const int term = search.table().Reference({feature});
      if (std::ranges::count(rule.references, term) > 0 ||
          !rule.covers.Meets(search.table().Bound(term))) {
        continue;
      }
      std::vector<int> references = rule.references;
      references.push_back(term);
      if (auto other = search.Make(std::move(references), rule.context)) {
        propose({{i}, {*other}});
      }
    }
  }
}

}  // namespace cell::rules
