#include "common/relational/state.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace cell {

State::State(int num_atoms)
    : num_atoms_(num_atoms),
      true_((static_cast<size_t>(num_atoms) + 63) / 64),
      unknown_(true_.size()) {}

void State::Check(int atom) const {
  if (atom < 0 || atom >= num_atoms_) {
    throw std::out_of_range("no ground predicate " + std::to_string(atom));
  }
}

Truth State::Get(int atom) const {
  Check(atom);
  const size_t word = static_cast<size_t>(atom) / 64;
  const uint64_t bit = uint64_t{1} << (atom % 64);
  if (unknown_[word] & bit) return Truth::kUnknown;
  return true_[word] & bit ? Truth::kTrue : Truth::kFalse;
}

void State::Set(int atom, Truth truth) {
  Check(atom);
  const size_t word = static_cast<size_t>(atom) / 64;
  const uint64_t bit = uint64_t{1} << (atom % 64);
  true_[word] &= ~bit;
  unknown_[word] &= ~bit;
  if (truth == Truth::kTrue) true_[word] |= bit;
  if (truth == Truth::kUnknown) unknown_[word] |= bit;
}

bool State::HasUnknown() const {
  return std::any_of(unknown_.begin(), unknown_.end(),
                     [](uint64_t word) { return word != 0; });
}

State State::UnknownAsFalse() const {
  State state = *this;
  std::fill(state.unknown_.begin(), state.unknown_.end(), 0);
  return state;
}

std::vector<int> State::UnknownAtoms() const {
  std::vector<int> atoms;
  for (int i = 0; i < num_atoms_; ++i) {
    if (Get(i) == Truth::kUnknown) atoms.push_back(i);
  }
  return atoms;
}

uint64_t State::Hash() const {
  uint64_t hash = 0xcbf29ce484222325;  // FNV-1a over words, with a mix
  for (const auto* words : {&true_, &unknown_}) {
    for (const uint64_t word : *words) {
      hash = (hash ^ word) * 0x100000001b3;
      hash ^= hash >> 29;
    }
  }
  return hash;
}

}  // namespace cell
