#include "common/relational/bound_condition.h"

#include <algorithm>

namespace cell {

BoundCondition::BoundCondition(std::span<const Literal> literals,
                               const Binding& binding,
                               const Vocabulary& vocabulary) {
  const State nothing(vocabulary.num_atoms());  // static literals need none
  for (const Literal& literal : literals) {
    if (!literal.is_static) {
      literals_.push_back(
          {Groundings(literal, binding, vocabulary), literal.is_negated});
    } else if (!cell::MayHold(literal, binding, nothing, vocabulary)) {
      is_possible_ = false;
    }
  }
}

bool BoundCondition::MayHold(const State& state) const {
  return is_possible_ &&
         std::ranges::all_of(literals_, [&](const BoundLiteral& literal) {
           return literal.MayHold(state);
         });
}

bool BoundCondition::BoundLiteral::MayHold(const State& state) const {
  bool is_unknown = false;
  for (const int atom : atoms) {
    const Truth truth = state.Get(atom);
    if (truth == Truth::kTrue) return !is_negated;
    is_unknown |= truth == Truth::kUnknown;
  }
  return is_negated || is_unknown;
}

}  // namespace cell
