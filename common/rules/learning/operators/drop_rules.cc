#include "common/rules/learning/operators/operators.h"

namespace cell::rules {

void DropRules(RuleSearch& search, const Propose& propose) {
  for (size_t i = 0; i < search.rules().size(); ++i) propose({{i}, {}});
}

}  // namespace cell::rules
