#pragma once

#include <span>
#include <vector>

#include "common/relational/literal.h"

namespace cell {

/// A conjunction of literals with the objects of its variables, as far as it
/// can be worked out without a state: static literals are decided, and the
/// others are lists of atoms. For conditions that are looked at in many states.
class BoundCondition {
 public:
  BoundCondition(std::span<const Literal> literals, const Binding& binding,
                 const Vocabulary& vocabulary);

  /// False if it holds in no state, because of static literals.
  bool is_possible() const { return is_possible_; }
  /// As MayHold() of the literals.
  bool MayHold(const State& state) const;

 private:
  struct BoundLiteral {
    std::vector<int> atoms;  ///< one of them is true, or none
    bool is_negated = false;

    bool MayHold(const State& state) const;
  };

  bool is_possible_ = true;
  std::vector<BoundLiteral> literals_;
};

}  // namespace cell
