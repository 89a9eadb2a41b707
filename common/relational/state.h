#pragma once

#include <cstdint>
#include <vector>

namespace cell {

enum class Truth : int8_t { kFalse = 0, kTrue = 1, kUnknown = 2 };

/// The truth of every ground atom of a vocabulary, two bits each; all false
/// at first.
class State {
 public:
  explicit State(int num_atoms);

  int num_atoms() const { return num_atoms_; }
  /// @throws std::out_of_range for an atom that is not there.
  Truth Get(int atom) const;
  void Set(int atom, Truth truth);

  bool HasUnknown() const;
  /// The state in which what is unknown is taken as false.
  State UnknownAsFalse() const;
  /// Ascending.
  std::vector<int> UnknownAtoms() const;

  bool operator==(const State&) const = default;
  /// The same in every process.
  uint64_t Hash() const;

 private:
  void Check(int atom) const;

  int num_atoms_;
  std::vector<uint64_t> true_;
  std::vector<uint64_t> unknown_;  // where set, the bit in true_ is not
};

}  // namespace cell
