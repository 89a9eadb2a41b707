#include "common/rules/quantified_atoms.h"

#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace cell::rules {

QuantifiedAtoms::QuantifiedAtoms(std::shared_ptr<const World> world)
    : world_(std::move(world)) {
  for (const Symbol& symbol : world_->symbols().all()) {
    first_.push_back(size_);
    if (!symbol.is_predicate()) continue;
    int number = 1;
    for (int i = 0; i < symbol.arity; ++i) number *= any() + 1;
    size_ += number;
  }
  for (size_t s = 0; s < first_.size(); ++s) {
    const int symbol = static_cast<int>(s);
    if (!world_->symbols()[symbol].is_predicate()) continue;
    const int end = world_->first(symbol) + world_->num_places(symbol);
    begin_.resize(static_cast<size_t>(end) + 1, atoms_.size());
    for (int place = world_->first(symbol); place < end; ++place) {
      begin_[static_cast<size_t>(place)] = atoms_.size();
      AddAtoms(symbol, world_->ObjectsAt(symbol, place), 0, 0);
    }
    begin_[static_cast<size_t>(end)] = atoms_.size();
  }
}

int QuantifiedAtoms::IndexOf(const Literal& literal,
                             std::span<const int> binding) const {
  std::array<int, kMaxArity> objects{};
  size_t arity = 0;
  for (const Term& term : literal.terms) {
    int object = any();
    if (term.kind == Term::Kind::kObject) object = term.index;
    if (term.kind == Term::Kind::kVariable) {
      object = binding[static_cast<size_t>(term.index)];
    }
    objects[arity++] = object;
  }
  return IndexOf(literal.symbol, std::span(objects).first(arity));
}

/// Adds the atoms with each object from `next` on, or with `_` in its place.
/// @param offset  of the terms before, among the symbol's atoms
void QuantifiedAtoms::AddAtoms(int symbol, std::span<const int> objects,
                               size_t next, int offset) {
  if (next == objects.size()) {
    atoms_.push_back(first_[static_cast<size_t>(symbol)] + offset);
    return;
  }
  for (const int object : {objects[next], any()}) {
    AddAtoms(symbol, objects, next + 1, offset * (any() + 1) + object);
  }
}

BitSet QuantifiedAtoms::TrueIn(const WorldState& state) const {
  BitSet atoms(size_);
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

}  // namespace cell::rules
