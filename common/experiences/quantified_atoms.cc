#include "common/experiences/quantified_atoms.h"

#include <bit>
#include <cstdint>
#include <utility>

namespace cell {

QuantifiedAtoms::QuantifiedAtoms(std::shared_ptr<const rules::World> world)
    : world_(std::move(world)) {
  for (const rules::Symbol& symbol : world_->symbols().all()) {
    first_.push_back(size_);
    if (!symbol.is_primitive_predicate()) continue;
    int number = 1;
    for (int i = 0; i < symbol.arity; ++i) number *= world_->num_objects() + 1;
    size_ += number;
  }
  for (size_t s = 0; s < first_.size(); ++s) {
    const int symbol = static_cast<int>(s);
    if (!world_->symbols()[symbol].is_primitive_predicate()) continue;
    const int end = world_->first(symbol) + world_->num_places(symbol);
    begin_.resize(static_cast<size_t>(end) + 1, atoms_.size());
    for (int place = world_->first(symbol); place < end; ++place) {
      begin_[static_cast<size_t>(place)] = atoms_.size();
      AddAtoms(symbol, world_->ObjectsAt(symbol, place), 0, 0);
    }
    begin_[static_cast<size_t>(end)] = atoms_.size();
  }
}

int QuantifiedAtoms::IndexOf(const rules::Literal& literal,
                             std::span<const int> binding) const {
  int offset = 0;
  for (const rules::Term& term : literal.terms) {
    int object = world_->num_objects();  // `_`
    if (term.kind == rules::Term::Kind::kObject) object = term.index;
    if (term.kind == rules::Term::Kind::kVariable) {
      object = binding[static_cast<size_t>(term.index)];
    }
    offset = offset * (world_->num_objects() + 1) + object;
  }
  return first_[static_cast<size_t>(literal.symbol)] + offset;
}

/// Adds the atoms with each object from `next` on, or with `_` in its place.
/// @param offset  of the terms before, among the symbol's atoms
void QuantifiedAtoms::AddAtoms(int symbol, std::span<const int> objects,
                               size_t next, int offset) {
  if (next == objects.size()) {
    atoms_.push_back(first_[static_cast<size_t>(symbol)] + offset);
    return;
  }
  for (const int object : {objects[next], world_->num_objects()}) {
    AddAtoms(symbol, objects, next + 1,
             offset * (world_->num_objects() + 1) + object);
  }
}

rules::BitSet QuantifiedAtoms::TrueIn(const rules::WorldState& state) const {
  rules::BitSet atoms(size_);
  for (size_t w = 0; w < state.bits.size(); ++w) {
    for (uint64_t word = state.bits[w]; word != 0; word &= word - 1) {
      const size_t place = 64 * w + static_cast<size_t>(std::countr_zero(word));
      if (place + 1 >= begin_.size()) break;
      for (size_t i = begin_[place]; i < begin_[place + 1]; ++i) {
        atoms.Add(atoms_[i]);
      }
    }
  }
  return atoms;
}

}  // namespace cell
