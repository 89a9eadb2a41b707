#include <algorithm>

#include "common/rules/learning/operators/operators.h"

namespace cell::rules {
namespace {

/// The literal with a variable of the rule in place of the constant.
void ProposeVariables(RuleSearch& search, const Propose& propose, size_t i,
                      size_t k, int32_t constant) {
  const SearchRule& rule = search.rules()[i];
  const Feature feature = search.table().feature(rule.context[k]);
  std::vector<int32_t> terms(rule.references.begin(), rule.references.end());
  for (int a = 0; a < search.table().num_arguments(); ++a) terms.push_back(a);
  const auto rest = search.Without(rule, k);
  for (const int32_t term : terms) {
    const int number = search.table().Number(feature.With(constant, term));
    if (auto other = search.With(*rest, number)) propose({{i}, {*other}});
  }
}

}  // namespace

void RaiseConstants(RuleSearch& search, const Propose& propose) {
  for (size_t i = 0; i < search.rules().size(); ++i) {
    const SearchRule& rule = search.rules()[i];
    for (size_t k = 0; k < rule.context.size(); ++k) {
      const Feature feature = search.table().feature(rule.context[k]);
      for (const int32_t term : feature.terms) {
        if (term >= Feature::kNone) continue;
        if (feature.symbol != Literal::kSame) {
          ProposeVariables(search, propose, i, k, term);
        } else if (auto other = search.Without(rule, k)) {
          propose({{i}, {*other}});
        }
      }
    }
  }
}

}  // namespace cell::rules
