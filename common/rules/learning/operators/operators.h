#pragma once

#include <array>
#include <functional>

#include "common/rules/learning/rule_search.h"

namespace cell::rules {

using Propose = std::function<void(const Proposal&)>;

// The search operators of Pasula, Zettlemoyer, Kaelbling (JAIR 2007), section
// 5.1, a file each. Each proposes changes of the rules; the search applies the
// best one if the score rises.

/// New rules for examples that no outcome explains.
void ExplainExamples(RuleSearch& search, const Propose& propose);
/// Without one rule.
void DropRules(RuleSearch& search, const Propose& propose);
/// Without one literal of a context, or of a reference that keeps others.
void DropLits(RuleSearch& search, const Propose& propose);
/// Without one reference and all literals that name it.
void DropRefs(RuleSearch& search, const Propose& propose);
/// "at most" or "at least" in place of "equal".
void GeneralizeEquality(RuleSearch& search, const Propose& propose);
/// Another bound in a literal that says "at most" or "at least".
void ChangeRanges(RuleSearch& search, const Propose& propose);
/// Two rules, with a literal and with its negation, in place of one.
void SplitOnLits(RuleSearch& search, const Propose& propose);
/// With one literal more.
void AddLits(RuleSearch& search, const Propose& propose);
/// With one reference more.
void AddRefs(RuleSearch& search, const Propose& propose);
/// A variable, or nothing, in place of a constant.
void RaiseConstants(RuleSearch& search, const Propose& propose);
/// A rule for each constant that an argument has been, in place of one.
void SplitVariables(RuleSearch& search, const Propose& propose);

struct SearchOperator {
  const char* name;
  void (*propose)(RuleSearch& search, const Propose& propose);
};
inline constexpr std::array<SearchOperator, 11> kSearchOperators = {{
    {"ExplainExamples", ExplainExamples},
    {"DropRules", DropRules},
    {"DropLits", DropLits},
    {"DropRefs", DropRefs},
    {"GeneralizeEquality", GeneralizeEquality},
    {"ChangeRanges", ChangeRanges},
    {"AddLits", AddLits},
    {"SplitOnLits", SplitOnLits},
    {"AddRefs", AddRefs},
    {"RaiseConstants", RaiseConstants},
    {"SplitVariables", SplitVariables},
}};

}  // namespace cell::rules
