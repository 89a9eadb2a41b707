#pragma once

#include <cstddef>
#include <optional>

#include "common/relational/rule.h"

namespace cell {

/// Appends the objects of the rule's references to `binding`, which has those
/// of its arguments. Returns the place of the first reference that does not
/// stand for exactly one object, before which it stops; nullopt if all do.
std::optional<size_t> BindReferences(const NdrRule& rule, const State& state,
                                     const Vocabulary& vocabulary,
                                     Binding* binding);

}  // namespace cell
