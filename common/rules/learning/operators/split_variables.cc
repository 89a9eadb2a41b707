#include "common/rules/learning/operators/operators.h"

namespace cell::rules {
namespace {

/// "argument = constant"
Feature IsConstant(int argument, int constant) {
  Feature feature;
  feature.symbol = Literal::kSame;
  feature.terms = {argument, Feature::ObjectCode(constant), Feature::kNone};
  return feature;
}

}  // namespace

void SplitVariables(RuleSearch& search, const Propose& propose) {
  FeatureTable& table = search.table();
  const int num_constants = table.world().num_constants();
  for (size_t i = 0; i < search.rules().size(); ++i) {
    const SearchRule& rule = search.rules()[i];
    for (int argument = 0; argument < table.num_arguments(); ++argument) {
      Proposal proposal{{i}, {}};
      std::optional<SearchRule> rest = rule;
      for (int c = 0; c < num_constants; ++c) {
        const Feature feature = IsConstant(argument, c);
        auto one = search.With(rule, table.Number(feature));
        if (!one) continue;
        proposal.added.push_back(std::move(*one));
        if (rest) rest = search.With(*rest, table.Number(feature.Negated()));
      }
      if (rest) proposal.added.push_back(std::move(*rest));
      if (proposal.added.size() > 1) propose(proposal);
    }
  }
}

}  // namespace cell::rules
