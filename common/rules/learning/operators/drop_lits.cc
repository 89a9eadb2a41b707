#include "common/rules/learning/operators/operators.h"

namespace cell::rules {

void DropLits(RuleSearch& search, const Propose& propose) {
  for (size_t i = 0; i < search.rules().size(); ++i) {
    const SearchRule& rule = search.rules()[i];
    for (size_t k = 0; k < rule.context.size(); ++k) {
      if (auto other = search.Without(rule, k)) propose({{i}, {*other}});
    }
    for (const int term : rule.references) {
      const std::vector<Feature> definition = search.table().definition(term);
      for (size_t k = 0; k < definition.size() && definition.size() > 1; ++k) {
        std::vector<Feature> rest = definition;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
        const int to = search.table().Reference(rest);
        if (auto other = search.WithReference(rule, term, to)) {
          propose({{i}, {*other}});
        }
      }
    }
  }
}

}  // namespace cell::rules
