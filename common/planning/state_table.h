#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/planning/model.h"
#include "common/planning/state_stream.h"

namespace cell::planning {

/// States with numbers from 0, in the order in which they came.
class StateTable {
 public:
  explicit StateTable(int num_words);

  int size() const { return size_; }
  Bits Words(int state) const {
    return Bits(words_).subspan(static_cast<size_t>(state) * num_words_,
                                num_words_);
  }
  /// The number of the state, which is size() - 1 if it is new.
  int Enter(Bits state);
  std::optional<int> Find(Bits state) const;
  int64_t num_bytes() const;

  void Save(StateWriter* out) const;
  /// @throws as StateReader does
  void Restore(StateReader* in);

 private:
  /// The slot that holds the state, or the free one where it belongs.
  size_t SlotOf(Bits state) const;
  void Grow();

  size_t num_words_;
  int size_ = 0;
  std::vector<uint64_t> words_;
  std::vector<int> slots_;  // open addressing; -1: free
};

}  // namespace cell::planning
