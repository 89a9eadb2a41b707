#pragma once

#include <span>

#include "common/relational/literal.h"

namespace cell {

/// True if one of its terms is a variable.
bool NamesVariable(const Literal& literal);

/// True of a predicate that arms report of themselves.
bool IsReported(const Literal& literal, const Vocabulary& vocabulary);

/// True if the literal may be `ground`, which names no variable, for some
/// objects of the types of its variables.
bool MayBe(const Literal& literal, std::span<const Variable> variables,
           const Literal& ground, const Vocabulary& vocabulary);

}  // namespace cell
