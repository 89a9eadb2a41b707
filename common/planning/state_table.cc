#include "common/planning/state_table.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace cell::planning {
namespace {

/// The finalizer of SplitMix64 over all words.
uint64_t HashOf(Bits state) {
  uint64_t hash = 0x9e3779b97f4a7c15;
  for (const uint64_t word : state) {
    hash = (hash ^ word) * 0xbf58476d1ce4e5b9;
    hash ^= hash >> 29;
    hash *= 0x94d049bb133111eb;
    hash ^= hash >> 32;
  }
  return hash;
}

}  // namespace

StateTable::StateTable(int num_words)
    : num_words_(static_cast<size_t>(num_words)), slots_(1024, -1) {}

size_t StateTable::SlotOf(Bits state) const {
  const size_t mask = slots_.size() - 1;
  size_t slot = HashOf(state) & mask;
  while (slots_[slot] >= 0 && !std::ranges::equal(Words(slots_[slot]), state)) {
    slot = (slot + 1) & mask;
  }
  return slot;
}

int StateTable::Enter(Bits state) {
  size_t slot = SlotOf(state);
  if (slots_[slot] >= 0) return slots_[slot];
  if (2 * static_cast<size_t>(size_ + 1) > slots_.size()) {
    Grow();
    slot = SlotOf(state);
  }
  if (size_ == std::numeric_limits<int>::max()) {
    throw std::length_error("more states than can be numbered");
  }
  words_.insert(words_.end(), state.begin(), state.end());
  return slots_[slot] = size_++;
}

std::optional<int> StateTable::Find(Bits state) const {
  const int found = slots_[SlotOf(state)];
  if (found < 0) return std::nullopt;
  return found;
}

void StateTable::Grow() {
  slots_.assign(2 * slots_.size(), -1);
  for (int state = 0; state < size_; ++state) {
    slots_[SlotOf(Words(state))] = state;
  }
}

void StateTable::Save(StateWriter* out) const {
  out->Put(size_);
  out->Put(words_);
  out->Put(slots_);
}

void StateTable::Restore(StateReader* in) {
  in->Get(&size_);
  in->Get(&words_);
  in->Get(&slots_);
}

int64_t StateTable::num_bytes() const {
  return static_cast<int64_t>(words_.capacity() * sizeof(uint64_t) +
                              slots_.capacity() * sizeof(int));
}

}  // namespace cell::planning
