#pragma once

#include <span>
#include <vector>

#include "common/relational/literal.h"
#include "common/sec/learned_model.h"

namespace cell {

/// Objects that could be used where the usual part of an action is missing:
/// they can stand in for it (StandIns()), fit what it would be put to, and are
/// not in use themselves as far as `state` says. In the order of the objects.
/// @param usual  objects of the model's roles, the usual part among them
std::vector<int> ProposeStandIns(const LearnedModel& model,
                                 std::span<const LearnedModel> all,
                                 const Binding& usual, const State& state,
                                 const Vocabulary& vocabulary);

}  // namespace cell
