#pragma once

#include <string>

#include "common/rules/symbols.h"
#include "common/rules/tokens.h"

namespace cell::rules {

/// The predicate or function of the name.
/// @param where  follows the name in the error: " before"
/// @throws RuleError at the place of `in` if there is none
int FactNamed(const std::string& name, const SymbolTable& symbols,
              const TokenReader& in, const std::string& where = "");

}  // namespace cell::rules
