#include <set>

#include "common/rules/learning/operators/operators.h"

namespace cell::rules {

void AddLits(RuleSearch& search, const Propose& propose) {
  for (size_t i = 0; i < search.rules().size(); ++i) {
    const SearchRule& rule = search.rules()[i];
    // Of literals that leave the same experiences, one is enough.
    std::set<uint64_t> tried = {rule.covers.Hash()};
    for (const int number : search.Literals(rule.references)) {
      BitSet covers = rule.covers;
      covers &= search.table().Before(number);
      if (covers.IsEmpty() || !tried.insert(covers.Hash()).second) continue;
      if (auto other = search.With(rule, number)) propose({{i}, {*other}});
    }
  }
}

}  // namespace cell::rules
