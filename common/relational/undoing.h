#pragma once

#include <optional>
#include <span>

#include "common/relational/domain.h"

namespace cell {

/// Place of the action among `actions` that `action` undoes, by what their
/// rules say: the success of that one makes predicates of the goals true of its
/// arguments, and the success of `action` makes all of them false again. A
/// success is the likeliest outcome; what is meant is what the rules of an
/// action have in common. nullopt if there is none, or more than one.
std::optional<int> DeriveUndone(const Action& action,
                                std::span<const Action> actions,
                                std::span<const Goal> goals);

}  // namespace cell
