#pragma once

#include <string>

#include "common/result/result.h"
#include "common/rules/rule.h"

namespace cell::rules {

/// The rules as a PPDDL domain: an action for each rule, named after its
/// action ("grab_2" for the second). References become parameters that are
/// unique by their precondition, `_` a quantifier, and noise leaves the state
/// as it is. Derived predicates are written as (:derived ...).
///
/// The reason names what PPDDL has no words for: counts, sums, and names that
/// differ in case only.
Result<std::string> ToPpddl(const NdrRules& rules, const std::string& name);

}  // namespace cell::rules
