#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/rules/learning/bit_set.h"
#include "common/rules/rule.h"

namespace cell {

/// The atoms of a world's primitive predicates, of which each term is an object
/// or `_`: an atom with `_` is true if it is for some object in its place. So
/// that a literal is looked up in a state, not worked out.
class QuantifiedAtoms {
 public:
  explicit QuantifiedAtoms(std::shared_ptr<const rules::World> world);

  int size() const { return size_; }
  /// The atom of a literal of a primitive predicate.
  /// @param binding  objects of the variables that it names
  int IndexOf(const rules::Literal& literal,
              std::span<const int> binding) const;
  /// Those that are true in the state.
  rules::BitSet TrueIn(const rules::WorldState& state) const;

 private:
  void AddAtoms(int symbol, std::span<const int> objects, size_t next,
                int offset);

  std::shared_ptr<const rules::World> world_;
  std::vector<int> first_;  // index of the first atom of each symbol
  // Of each place of a state, the atoms that are true if it is:
  // atoms_[begin_[place]] to atoms_[begin_[place + 1]].
  std::vector<size_t> begin_;
  std::vector<int> atoms_;
  int size_ = 0;
};

}  // namespace cell
