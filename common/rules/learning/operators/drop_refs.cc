#include "common/rules/learning/operators/operators.h"

namespace cell::rules {

void DropRefs(RuleSearch& search, const Propose& propose) {
  for (size_t i = 0; i < search.rules().size(); ++i) {
    const SearchRule& rule = search.rules()[i];
    for (const int term : rule.references) {
      if (auto other = search.WithReference(rule, term, std::nullopt)) {
        propose({{i}, {*other}});
      }
    }
  }
}

}  // namespace cell::rules
