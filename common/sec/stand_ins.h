#pragma once

#include <set>
#include <span>

#include "common/relational/vocabulary.h"
#include "common/sec/learned_model.h"

namespace cell {

/// Objects that can stand in for the moved part of a model, although their
/// types were never shown in that role: everything that must change can be said
/// of them, and no model that changes the same predicates takes their type (an
/// object that has an action of its own stands in for none). Whether one fits
/// the other roles is up to the model's static relations. None if the model
/// requires no predicate to change.
std::set<int> StandIns(const LearnedModel& model,
                       std::span<const LearnedModel> all,
                       const Vocabulary& vocabulary);

}  // namespace cell
