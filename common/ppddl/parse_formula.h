#pragma once

#include "common/ppddl/expression.h"
#include "common/ppddl/scope.h"

namespace cell::ppddl {

/// @throws PpddlError
Condition ParseCondition(const Expression& expression, Scope& scope);
Effect ParseEffect(const Expression& expression, Scope& scope);

}  // namespace cell::ppddl
