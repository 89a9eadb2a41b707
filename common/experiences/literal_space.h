#pragma once

#include <functional>
#include <vector>

#include "common/rules/rule.h"

namespace cell {

/// Calls visit(literal) for both polarities of every primitive predicate with
/// every choice of terms, in the order of symbols and terms.
void ForEachLiteral(const std::vector<rules::Term>& terms,
                    const rules::World& world,
                    const std::function<void(const rules::Literal&)>& visit);

/// The arguments of the rule's action as terms.
std::vector<rules::Term> ArgumentTerms(const rules::Rule& rule);

/// True if one of its terms is a variable.
bool NamesVariable(const rules::Literal& literal);

/// True if all terms are `_`.
bool NamesNothing(const rules::Literal& literal);

}  // namespace cell
