#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/rules/learning/bit_set.h"
#include "common/rules/rule.h"
#include "common/rules/world.h"

namespace cell::rules {

/// The atoms of a world's predicates, of which each term is an object or `_`:
/// an atom with `_` is true if it is for some object in its place. So that a
/// literal is looked up in a state, not worked out.
class QuantifiedAtoms {
 public:
  explicit QuantifiedAtoms(std::shared_ptr<const World> world);

  int size() const { return size_; }
  /// The object that stands for `_`.
  int any() const { return world_->num_objects(); }
  /// The atom of a predicate.
  int IndexOf(int symbol, std::span<const int> objects) const {
    int offset = 0;
    for (const int object : objects) offset = offset * (any() + 1) + object;
    return first_[static_cast<size_t>(symbol)] + offset;
  }
  /// The atom of a literal of a predicate.
  /// @param binding  objects of the variables that it names
  int IndexOf(const Literal& literal, std::span<const int> binding) const;
  /// Those that are true in the state.
  BitSet TrueIn(const WorldState& state) const;

 private:
  void AddAtoms(int symbol, std::span<const int> objects, size_t next,
                int offset);

  std::shared_ptr<const World> world_;
  std::vector<int> first_;  // index of the first atom of each symbol
  // Of each place of a state, the atoms that are true if it is:
  // atoms_[begin_[place]] to atoms_[begin_[place + 1]].
  std::vector<size_t> begin_;
  std::vector<int> atoms_;
  int size_ = 0;
};

}  // namespace cell::rules
